// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/geometry/recover_scanner.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/geometry/beam_bearings.h"
#include "core/geometry/pitch_axis.h"

namespace planewright {

namespace {

constexpr double kPitchTurn = 2.0 * std::numbers::pi;
constexpr double kUpright = 0.9;  ///< an axis whose z is larger has no "level" about it

/// The frame of Eq. (6) in the cloud's: the axis, then what is ahead and what is above, as far as the axis lets them
/// be; ahead is where the slices look on the whole.
Eigen::Matrix3d attitudeOf(const PitchAxis& axis)
{
    const Eigen::Vector3d& a = axis.direction;
    Eigen::Vector3d ahead;
    if (std::abs(a.z()) < kUpright)
        ahead = (Eigen::Vector3d::UnitZ() - a.z() * a).normalized().cross(a);
    else
        ahead = (Eigen::Vector3d::UnitY() - a.y() * a).normalized();
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& one : axis.ahead)
        sum += one;
    if (sum.dot(ahead) < 0.0)
        ahead = -ahead;
    Eigen::Matrix3d attitude;
    attitude << a, ahead, a.cross(ahead);
    return attitude;
}

/// Pitches of slices one after another, each within half a turn of the one before, moved by whole turns to within a
/// turn of zero.
void unwrap(std::vector<double>& tilts)
{
    if (tilts.empty())
        return;
    for (std::size_t i = 1; i < tilts.size(); ++i)
        tilts[i] -= kPitchTurn * std::round((tilts[i] - tilts[i - 1]) / kPitchTurn);
    const auto [lowest, highest] = std::minmax_element(tilts.begin(), tilts.end());
    const double shift = kPitchTurn * std::round(0.5 * (*lowest + *highest) / kPitchTurn);
    for (double& tilt : tilts) {
        tilt -= shift;
        if (std::abs(tilt) > kPitchTurn)
            tilt = std::remainder(tilt, kPitchTurn);
    }
}

/// The slices that have a pitch, by their numbers, and the pitches.
struct PitchedSlices {
    std::vector<std::size_t> numbers;
    std::vector<double> tilts;
};

PitchedSlices pitchedSlices(const PitchAxis& axis, const Eigen::Matrix3d& attitude)
{
    PitchedSlices pitched;
    for (std::size_t i = 0; i < axis.ahead.size(); ++i) {
        if (axis.ahead[i].isZero(0.0))
            continue;
        pitched.numbers.push_back(i);
        pitched.tilts.push_back(std::atan2(axis.ahead[i].dot(attitude.col(1)), -axis.ahead[i].dot(attitude.col(2))));
    }
    unwrap(pitched.tilts);
    return pitched;
}

/// Bearings of the points of a slice, each within half a turn of the one before.
std::vector<double> bearingsOf(const CloudSlice& slice, const Eigen::Vector3d& axis, const Eigen::Vector3d& ahead)
{
    std::vector<double> bearings;
    bearings.reserve(slice.size());
    for (const CloudPoint& point : slice) {
        const Eigen::Vector3d place = point.place.cast<double>();
        double bearing = std::atan2(place.dot(ahead), place.dot(axis));
        if (!bearings.empty())
            bearing -= kPitchTurn * std::round((bearing - bearings.back()) / kPitchTurn);
        bearings.push_back(bearing);
    }
    return bearings;
}

/// Turns the slices round that were swept the other way: from then on bearings rise in all of them.
void turnRound(std::vector<SeenBearings>& slices)
{
    for (SeenBearings& seen : slices) {
        if (seen.bearings.back() >= seen.bearings.front())
            continue;
        std::reverse(seen.bearings.begin(), seen.bearings.end());
        std::reverse(seen.slice->begin(), seen.slice->end());
    }
}

/// The ranges of a slice's points; of two on one beam the first.
std::vector<double> rangesOf(const CloudSlice& slice, int beams)
{
    std::vector<double> ranges(static_cast<std::size_t>(beams), 0.0);
    for (const CloudPoint& point : slice) {
        double& range = ranges[static_cast<std::size_t>(point.beam)];
        if (range == 0.0)
            range = point.place.cast<double>().norm();
    }
    return ranges;
}

}  // namespace

Result<Recording> recoverScanner(CloudScan& cloud)
{
    const auto axis = fitPitchAxis(cloud.slices);
    if (!axis)
        return fail(ErrorCode::Unreadable,
                    "there are no two slices with points in different planes; a scan has many, through one axis");
    const Eigen::Matrix3d attitude = attitudeOf(*axis);
    const PitchedSlices pitched = pitchedSlices(*axis, attitude);
    if (pitched.numbers.size() < 2)
        return fail(ErrorCode::Unreadable,
                    "there are no two slices with points off their common axis; a scan has many");
    std::vector<SeenBearings> seen;
    for (std::size_t i = 0; i < pitched.numbers.size(); ++i) {
        CloudSlice& slice = cloud.slices[pitched.numbers[i]];
        seen.push_back({pitched.tilts[i], bearingsOf(slice, axis->direction, axis->ahead[pitched.numbers[i]]), &slice});
    }
    if (cloud.beams == 0) {
        turnRound(seen);
        const auto numbered = numberBeams(seen);
        if (!numbered)
            return tl::unexpected{numbered.error()};
        cloud.beams = *numbered;
    }
    const auto beams = layBearings(seen, cloud.beams);
    if (!beams)
        return tl::unexpected{beams.error()};

    Recording recording;
    ScanDescription& description = recording.description;
    description.scanner = cloud.scanner;
    description.beams = cloud.beams;
    description.firstBearing = beams->first;
    description.bearingStep = beams->step;
    description.beamTable = beams->table;
    description.attitude = attitude.isIdentity(1e-9) ? Eigen::Quaterniond::Identity() : Eigen::Quaterniond(attitude);
    double farthest = 0.0;
    for (std::size_t i = 0; i < pitched.numbers.size(); ++i) {
        ScanSlice& slice = recording.slices.emplace_back();
        slice.step = static_cast<int>(pitched.numbers[i]);
        slice.tilt = pitched.tilts[i];
        slice.ranges = rangesOf(cloud.slices[pitched.numbers[i]], cloud.beams);
        layBeams(slice, description);
        farthest = std::max(farthest, *std::max_element(slice.ranges.begin(), slice.ranges.end()));
    }
    description.rangeMax = std::ceil(farthest) + 1.0;
    return recording;
}

}  // namespace planewright
