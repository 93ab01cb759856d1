// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/cli/scan_setup_options.h"

#include <charconv>
#include <cmath>

#include "app/cli/console.h"
#include "app/cli/number_option.h"
#include "app/cli/tilt_options.h"
#include "core/types/angle.h"
#include "core/types/recording.h"

namespace planewright {

namespace {

bool isGiven(double number)
{
    return !std::isnan(number);
}

/// "A:B" in degrees.
Result<std::pair<double, double>> parseBearings(const std::string& text)
{
    const auto wrong = [&] {
        return fail(ErrorCode::Usage, "--bearing: '" + text + "' is no scan angle; give A:B in degrees, as in 0:180");
    };
    const std::size_t colon = text.find(':');
    if (colon == std::string::npos)
        return wrong();
    double angles[2]{};
    const std::string parts[2]{text.substr(0, colon), text.substr(colon + 1)};
    for (int i = 0; i < 2; ++i) {
        const char* const end = parts[i].data() + parts[i].size();
        const auto [stopped, error] = std::from_chars(parts[i].data(), end, angles[i]);
        if (error != std::errc{} || stopped != end || !(std::abs(angles[i]) <= 360.0))
            return wrong();
    }
    return std::pair{degrees(angles[0]), degrees(angles[1])};
}

Result<ScanPlan> planOf(const ScanSetupOptions& options, const AcquisitionSettings& settings)
{
    ScanPlan plan;
    plan.mode = options.stepAndStare ? ScanPlan::Mode::StepAndStare : ScanPlan::Mode::Continuous;
    plan.firstPitch = settings.firstTilt;
    plan.pitchStep = settings.tiltStep;
    plan.slices = settings.slices;
    if (options.cluster > 0)
        plan.cluster = options.cluster;
    if (options.settle >= 0)
        plan.settle = std::chrono::milliseconds{options.settle};
    if (isGiven(options.travelSpeed))
        plan.travelSpeed = degrees(options.travelSpeed);
    if (isGiven(options.axisOffset))
        plan.pitchAxisOffset = options.axisOffset;
    if (!options.bearing.empty()) {
        const auto bearings = parseBearings(options.bearing);
        if (!bearings)
            return tl::unexpected{bearings.error()};
        plan.firstBearing = bearings->first;
        plan.lastBearing = bearings->second;
    }
    return plan;
}

/// Errors (Usage): an option that would do nothing.
Result<void> checkKind(const ScanSetupOptions& options, SourceAddress::Kind kind)
{
    const bool isOfDevices = !options.tiltUnit.empty() || !options.bearing.empty() || options.cluster > 0 ||
                             options.stepAndStare || options.settle >= 0 || isGiven(options.travelSpeed) ||
                             isGiven(options.axisOffset) || !options.dialogueFolder.empty();
    if (kind != SourceAddress::Kind::Laser && isOfDevices)
        return fail(ErrorCode::Usage,
                    "--tilt-unit, --bearing, --cluster, --step-and-stare, --settle, --travel-speed, --axis-offset and "
                    "--dialogues "
                    "are for a laser; leave them out");
    if (kind == SourceAddress::Kind::Replay && (!options.tilt.empty() || options.slices > 0))
        return fail(ErrorCode::Usage, "--tilt, --slices: a replay has the slices of its recording; leave them out");
    if (kind == SourceAddress::Kind::Laser && options.tiltUnit.empty())
        return fail(ErrorCode::Usage,
                    "--tilt-unit: a laser needs one to scan with; give dynamixel:usb:, board:usb:, "
                    "dynamixel:serial:PATH or another (planewright-cli devices lists them)");
    return {};
}

}  // namespace

void addScanSetupOptions(CLI::App& command, ScanSetupOptions& options)
{
    command
        .add_option("--tilt-unit", options.tiltUnit,
                    "what tilts the laser: dynamixel: or board:, and then usb:SERIAL, serial:PATH, tcp:HOST:PORT or "
                    "dialogue:FILE, as in dynamixel:usb:SERIAL?id=1&baud=57142; zero=, sign= and scale= tell how it is "
                    "mounted, lowest= and highest= (degrees) where "
                    "it "
                    "may go, fastest= (degrees a second) how fast")
        ->type_name("ADDRESS");
    command.add_option("--tilt", options.tilt, "pitch of the slices in degrees (default 10:170:1.16, 137 slices)")
        ->type_name("A:B:STEP");
    addWholeNumber(command, "--slices", options.slices, 1, kMaxSlices, "number of slices, whatever --tilt says");
    command.add_option("--bearing", options.bearing, "scan angle of a laser in degrees (default 0:180)")
        ->type_name("A:B");
    addWholeNumber(command, "--cluster", options.cluster, 1, LaserBeams::kMostJoinedSteps,
                   "steps of the laser that give one range together, the least of them (default 1)");
    command.add_flag("--step-and-stare", options.stepAndStare,
                     "the head stands still for each slice; without it the head nods at constant speed");
    addWholeNumber(command, "--settle", options.settle, 0, 10'000,
                   "with --step-and-stare: rest before a slice in ms (default 8)");
    addNumber(command, "--travel-speed", options.travelSpeed, 1.0, 720.0,
              "speed between steps, and to where a scan begins, in degrees a second (default 90)");
    addNumber(command, "--axis-offset", options.axisOffset, -1.0, 1.0,
              "d_l, the distance from the axis of the tilt to the laser's origin in metres (default 0.05)");
    command
        .add_option("--dialogues", options.dialogueFolder,
                    "folder in which every byte to and from the devices is recorded")
        ->type_name("FOLDER");
}

Result<SourceSetup> sourceSetupOf(const ScanSetupOptions& options, SourceAddress::Kind kind)
{
    if (const Result<void> checked = checkKind(options, kind); !checked)
        return tl::unexpected{checked.error()};
    AcquisitionSettings settings;  // Table VIII
    if (const auto tilt = takeTilt(options.tilt, options.slices, settings); !tilt)
        return tl::unexpected{tilt.error()};
    const Result<ScanPlan> plan = planOf(options, settings);
    if (!plan)
        return tl::unexpected{plan.error()};
    SourceSetup setup;
    setup.simulation = {settings, defaultSimulationNoise(), 1, 1.0};
    setup.nodding = {options.tiltUnit, *plan, options.dialogueFolder,
                     [](const std::string& line) { printWaiting(line); }};
    return setup;
}

}  // namespace planewright
