// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/formats/cloud_recording.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/formats/geometry_keys.h"
#include "core/formats/number_cells.h"
#include "core/formats/number_text.h"
#include "core/formats/recorded_slice.h"
#include "core/geometry/recover_scanner.h"
#include "core/geometry/sensor_model.h"
#include "core/types/angle.h"
#include "core/types/square.h"

namespace planewright {

namespace {

constexpr double kRounding = 0.5e-3;        ///< of a range [m]
constexpr std::size_t kMostLeftOut = 1000;  ///< one point of so many

std::string inMillimetres(double metres)
{
    return formatNumber(std::round(metres * 1e6) / 1e3);
}

/// An angle [rad] as a text of degrees has it, in any kind of recording.
double asInText(double radians)
{
    return degrees(readNumber<double>(formatNumber(toDegrees(radians))).value_or(0.0));
}

/// Holds all points against the recording; those that are too far off become no returns.
void measure(const CloudScan& cloud, CloudRecording& made, double& largestAngle)
{
    const SensorModel sensor = sensorOf(made.recording.description);
    double sum = 0.0;
    for (ScanSlice& slice : made.recording.slices) {
        std::vector<bool> isTaken(slice.ranges.size());
        for (const CloudPoint& point : cloud.slices[static_cast<std::size_t>(slice.step)]) {
            const auto beam = static_cast<std::size_t>(point.beam);
            const Eigen::Vector3d place = point.place.cast<double>();
            const Eigen::Vector3d recorded = toCartesian(slice.ranges[beam], slice.bearing(beam), slice.tilt, sensor);
            const double off = (place - recorded).norm();
            if (isTaken[beam] || off > kRecoveryTolerance * place.norm() + kRounding) {
                ++made.pointsLeftOut;
                largestAngle = std::max(largestAngle, off / place.norm());
                if (!isTaken[beam])
                    slice.ranges[beam] = 0.0;
            } else {
                made.largestOff = std::max(made.largestOff, off);
                sum += square(off);
                ++made.points;
            }
            isTaken[beam] = true;
        }
    }
    made.rmsOff = std::sqrt(sum / static_cast<double>(std::max<std::size_t>(1, made.points)));
}

std::string axisText(const Eigen::Vector3d& axis)
{
    std::string text;
    for (const double value : axis) {
        text += text.empty() ? "" : " ";
        appendNumber(text, std::round(value * 1e6) / 1e6);
    }
    return text;
}

std::string_view beamsText(const ScanDescription& description)
{
    if (!description.beamTable)
        return "evenly spaced";
    return description.beamTable->imageTilt ? "of a flat image" : "each its own bearing";
}

}  // namespace

Result<CloudRecording> recordingOf(CloudScan cloud, const std::string& place)
{
    auto recovered = recoverScanner(cloud);
    if (!recovered)
        return fail(recovered.error().code, place + ": " + recovered.error().message);
    CloudRecording made;
    for (double* angle : {&recovered->description.firstBearing, &recovered->description.bearingStep})
        *angle = asInText(*angle);
    made.recording.description = asWritten(std::move(recovered->description));
    made.recording.slices.reserve(recovered->slices.size());
    for (ScanSlice& slice : recovered->slices) {
        slice.tilt = asInText(slice.tilt);
        ScanSlice written = asRecorded(std::move(slice));
        layBeams(written, made.recording.description);
        made.recording.slices.push_back(std::move(written));
    }
    std::size_t points = 0;
    for (const CloudSlice& slice : cloud.slices)
        points += slice.size();
    double largestAngle = 0.0;
    measure(cloud, made, largestAngle);
    made.pointsLeftOut = points - made.points;
    if (made.pointsLeftOut * kMostLeftOut > points)
        return fail(ErrorCode::Unreadable,
                    place + ": no nodding scanner explains these points: " + std::to_string(made.pointsLeftOut) +
                        " of " + std::to_string(points) + " are off by more than 1 mm on each metre, by up to " +
                        formatNumber(std::round(largestAngle * 1e4) / 10.0) +
                        " mm on each. Give slices that are planar rows through one axis of the scanner, seen from the "
                        "scanner at the origin, as they were measured");
    ScanDescription& description = made.recording.description;
    if (description.beamTable && description.beamTable->imageTilt)
        description.scanner = "depth camera, " + description.scanner;
    description.extra = {
        {"recovered_axis", axisText(description.attitude * Eigen::Vector3d::UnitX())},
        {"recovered_beams", std::string{beamsText(description)}},
        {"recovered_largest_off_mm", inMillimetres(made.largestOff)},
        {"recovered_rms_off_mm", inMillimetres(made.rmsOff)},
    };
    for (std::size_t i = 0; i < cloud.notes.size(); ++i)
        description.extra.emplace_back(i == 0 ? "recovered_note" : "recovered_note_" + std::to_string(i + 1),
                                       cloud.notes[i]);
    return made;
}

}  // namespace planewright
