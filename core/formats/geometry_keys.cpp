// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/formats/geometry_keys.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/formats/number_cells.h"
#include "core/formats/number_text.h"
#include "core/formats/recorded_slice.h"
#include "core/types/angle.h"

namespace planewright {

namespace {

constexpr std::string_view kBearings = "beam_bearings_deg";
constexpr std::string_view kImagePitch = "beam_image_pitch_deg";
constexpr std::string_view kFrame = "frame_quaternion";
constexpr double kLargestBeamAngle = 360.0;

/// The numbers of a text, separated by single blanks; empty where one is none, or there are more than `most`.
std::vector<double> numbersIn(std::string_view text, std::size_t most)
{
    std::vector<double> numbers;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find(' '), text.size());
        const auto number = readNumber<double>(text.substr(0, end));
        if (!number || numbers.size() == most)
            return {};
        numbers.push_back(*number);
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return numbers;
}

void appendWord(std::string& text, double value)
{
    text += text.empty() ? "" : " ";
    appendNumber(text, value);
}

/// Takes the value of a key out; nothing where it is not there.
std::optional<std::string> take(ExtraKeys& extra, std::string_view key)
{
    const auto found = std::find_if(extra.begin(), extra.end(), [&](const auto& one) { return one.first == key; });
    if (found == extra.end())
        return std::nullopt;
    std::string value = std::move(found->second);
    extra.erase(found);
    return value;
}

std::string takeBearings(const std::string& text, const std::optional<std::string>& imagePitch,
                         ScanDescription& description)
{
    auto table = std::make_shared<BeamTable>();
    table->bearings = numbersIn(text, kMaxBeams);
    bool rises = table->bearings.size() == static_cast<std::size_t>(description.beams);
    double before = -2.0 * kLargestBeamAngle;
    for (double& bearing : table->bearings) {
        rises = rises && bearing > before && std::abs(bearing) <= kLargestBeamAngle;
        before = bearing;
        bearing = degrees(bearing);
    }
    if (!rises)
        return std::string{kBearings} + " is no list of rising angles from -360 to 360, one for each of the " +
               std::to_string(description.beams) + " beams";
    if (imagePitch) {
        const auto pitch = readNumber<double>(*imagePitch);
        if (!pitch || std::abs(*pitch) > kLargestBeamAngle)
            return std::string{kImagePitch} + " is no angle from -360 to 360 degrees";
        if (table->bearings.front() <= 0.0 || table->bearings.back() >= degrees(180.0))
            return std::string{kBearings} + " of an image are between 0 and 180 degrees";
        table->imageTilt = degrees(*pitch);
    }
    description.beamTable = std::move(table);
    return {};
}

}  // namespace

bool isGeometryKey(std::string_view key)
{
    return key == kBearings || key == kImagePitch || key == kFrame;
}

ExtraKeys keysOf(const ScanDescription& description)
{
    ExtraKeys keys = description.extra;
    if (description.beamTable) {
        std::string text;
        for (const double bearing : description.beamTable->bearings)
            appendWord(text, toDegrees(bearing));
        keys.emplace_back(kBearings, std::move(text));
        if (description.beamTable->imageTilt)
            keys.emplace_back(kImagePitch, formatNumber(toDegrees(*description.beamTable->imageTilt)));
    }
    if (description.isTurned()) {
        const Eigen::Quaterniond& q = description.attitude;
        std::string text;
        for (const double value : {q.w(), q.x(), q.y(), q.z()})
            appendWord(text, value);
        keys.emplace_back(kFrame, std::move(text));
    }
    return keys;
}

std::string takeGeometryKeys(ScanDescription& description)
{
    const auto bearings = take(description.extra, kBearings);
    const auto imagePitch = take(description.extra, kImagePitch);
    const auto frame = take(description.extra, kFrame);
    if (imagePitch && !bearings)
        return std::string{kImagePitch} + " is of no use without " + std::string{kBearings};
    if (bearings) {
        if (std::string problem = takeBearings(*bearings, imagePitch, description); !problem.empty())
            return problem;
    }
    if (frame) {
        const std::vector<double> q = numbersIn(*frame, 4);
        const Eigen::Quaterniond attitude =
            q.size() == 4 ? Eigen::Quaterniond{q[0], q[1], q[2], q[3]} : Eigen::Quaterniond{0.0, 0.0, 0.0, 0.0};
        if (!(std::abs(attitude.norm() - 1.0) < 1e-3))
            return std::string{kFrame} + " is no unit quaternion w x y z";
        description.attitude = attitude.normalized();
    }
    return {};
}

ScanDescription asWritten(ScanDescription description)
{
    description = asRecorded(std::move(description));
    description.extra = keysOf(description);
    description.beamTable.reset();
    description.attitude.setIdentity();
    [[maybe_unused]] const std::string problem = takeGeometryKeys(description);
    assert(problem.empty());
    return description;
}

}  // namespace planewright
