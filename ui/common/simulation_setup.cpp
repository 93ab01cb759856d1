// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/common/simulation_setup.h"

#include <charconv>
#include <cmath>

#include "core/formats/number_text.h"
#include "core/formats/recording_csv.h"
#include "core/types/angle.h"
#include "core/types/angle_range.h"
#include "core/types/recording.h"

namespace planewright {

namespace {

constexpr double kTurn = 360.0;
constexpr auto kMostPoints = static_cast<std::int64_t>(kMaxRanges);

/// A whole number with commas between thousands.
std::string grouped(std::int64_t number)
{
    std::string text = std::to_string(number);
    for (auto at = static_cast<std::ptrdiff_t>(text.size()) - 3; at > 0; at -= 3)
        text.insert(static_cast<std::size_t>(at), ",");
    return text;
}

/// Seconds with one digit, minutes above two of them.
std::string durationText(double seconds)
{
    constexpr double kTwoMinutes = 120.0;
    char text[64];
    const double shown = seconds < kTwoMinutes ? seconds : seconds / 60.0;
    const auto end = std::to_chars(text, text + sizeof text, shown, std::chars_format::fixed, 1);
    return std::string{text, end.ptr} + (seconds < kTwoMinutes ? " s" : " min");
}

/// How many angles a range holds, or what to give instead.
Result<int> count(const std::string& what, double first, double last, double step, RangeEnd end, int most)
{
    const auto refuse = [&](const std::string& why) { return fail(ErrorCode::Usage, what + ": " + why); };
    if (std::abs(first) > kTurn || std::abs(last) > kTurn)
        return refuse("give angles from -360° to 360°.");
    if (step == 0.0 || (last - first) / step < 0.0)
        return refuse("give a step that leads from the first angle to the last.");
    const double angles = angleCount(first, last, step, end);
    if (angles < 1.0)
        return refuse("give a smaller step; this one leads past the end.");
    if (angles > most)
        return refuse("give a larger step; this one makes more than " + grouped(most) + " angles.");
    return static_cast<int>(angles);
}

}  // namespace

Result<AcquisitionSettings> acquisitionOf(const SimulationSetup& setup)
{
    const Result<int> slices =
        count("Tilt", setup.firstTilt, setup.lastTilt, setup.tiltStep, RangeEnd::Open, kMaxSlices);
    if (!slices)
        return tl::unexpected{slices.error()};
    if (setup.bearingStep < 0.0)
        return fail(ErrorCode::Usage, "Bearing: give a step above 0; bearings rise from beam to beam.");
    const Result<int> beams =
        count("Bearing", setup.firstBearing, setup.lastBearing, setup.bearingStep, RangeEnd::Closed, kMaxBeams);
    if (!beams)
        return tl::unexpected{beams.error()};
    if (std::int64_t{*slices} * *beams > kMostPoints)
        return fail(ErrorCode::Usage, "These are more than " + grouped(kMostPoints) + " points. Give larger steps.");
    AcquisitionSettings settings;
    settings.firstTilt = degrees(setup.firstTilt);
    settings.tiltStep = degrees(setup.tiltStep);
    settings.slices = *slices;
    settings.firstBearing = degrees(setup.firstBearing);
    settings.bearingStep = degrees(setup.bearingStep);
    settings.beams = *beams;
    return settings;
}

Result<AcquisitionSettings> acquisitionWith(const DeviceSetup& setup)
{
    SimulationSetup same;
    same.firstTilt = setup.firstTilt;
    same.lastTilt = setup.lastTilt;
    same.tiltStep = setup.tiltStep;
    same.firstBearing = setup.firstBearing;
    same.lastBearing = setup.lastBearing;
    Result<AcquisitionSettings> settings = acquisitionOf(same);
    constexpr int kTurnsOfAStep = 3;
    if (settings && setup.stepAndStare)
        settings->sliceTime *= kTurnsOfAStep;
    return settings;
}

std::string addressOf(const SimulationSetup& setup)
{
    return "sim:" + setup.scene + "?seed=" + std::to_string(setup.seed) + "&speed=" + exactNumber(setup.speed);
}

std::string scanSizeText(const AcquisitionSettings& settings)
{
    const std::int64_t points = std::int64_t{settings.slices} * settings.beams;
    const double seconds = std::chrono::duration<double>(settings.sliceTime).count() * settings.slices;
    return grouped(settings.slices) + (settings.slices == 1 ? " step × " : " steps × ") + grouped(settings.beams) +
           " points = " + grouped(points) + " points, about " + durationText(seconds);
}

}  // namespace planewright
