// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/sources/open_source.h"

#include <algorithm>
#include <utility>

#include "app/files/recording_file.h"
#include "app/sources/device_opener.h"
#include "core/formats/parameter_events.h"
#include "devices/nodding/nodding_source.h"
#include "devices/replay/replayed_recording.h"

namespace planewright {

namespace {

Result<OpenedSource> openRoom(const SourceAddress& address, SimulatedScanner scanner, const Clock& clock)
{
    Result<Scene> scene = makeScene(address.name, address.seed);
    if (!scene)
        return tl::unexpected{scene.error()};
    scanner.seed = address.seed;
    scanner.speed = address.speed;
    OpenedSource opened;
    opened.source = std::make_shared<SimulatedRoom>(std::move(*scene), scanner, clock);
    return opened;
}

Result<OpenedSource> openLaserOnTiltUnit(const DeviceAddress& laser, const NoddingSetup& setup, const Clock& clock,
                                         const std::stop_token& stop)
{
    if (setup.tiltUnit.empty())
        return fail(ErrorCode::Usage,
                    "a laser needs a tilt unit to scan with; name it, as in dynamixel:usb: or board:usb:");
    const Result<DeviceAddress> unit = parseDeviceAddress(setup.tiltUnit);
    if (!unit)
        return tl::unexpected{unit.error()};
    if (unit->unit == DeviceAddress::Unit::Laser)
        return fail(
            ErrorCode::Usage,
            "'" + setup.tiltUnit + "': this is the address of a laser; a tilt unit's begins with dynamixel: or board:");
    const auto opener = std::make_shared<DeviceOpener>(clock, DeviceOptions{setup.dialogueFolder, setup.progress});
    const auto scanner = std::make_shared<KnownScanner>();
    NoddingDevices devices;
    devices.openLaser = [opener, laser, scanner](const std::stop_token& asked) {
        auto opened = opener->openLaser(laser, asked);
        if (opened)
            scanner->laser = (*opened)->limits();
        return opened;
    };
    devices.openTiltUnit = [opener, unit = *unit, scanner](const std::stop_token& asked) {
        auto opened = opener->openTiltUnit(unit, asked);
        if (opened)
            note(**opened, *scanner);
        return opened;
    };
    devices.takeLog = [opener] { return opener->takeLog(); };
    Result<std::unique_ptr<NoddingSource>> source = NoddingSource::open(std::move(devices), setup.plan, clock, stop);
    // Of a device that is gone before the scan nothing was lost.
    if (!source && source.error().code == ErrorCode::DeviceLost)
        return fail(ErrorCode::NoDevice, source.error().message);
    if (!source)
        return tl::unexpected{source.error()};
    OpenedSource opened;
    opened.plan = (*source)->fittedPlan();
    opened.scanner = *scanner;
    opened.source = std::move(*source);
    return opened;
}

/// Edits go where the scan was read from. A file that cannot even be opened for that can still be looked at.
void openProject(const std::string& path, const ScanNotes& notes, OpenedSource& opened)
{
    opened.scan = notes.scan.id;
    opened.edits = notes.edits;
    Result<PwscanProject> project = PwscanProject::open(path);
    if (project)
        opened.project = std::move(*project);
    else
        opened.warnings.push_back(project.error().message);
}

/// How many steps the scan of a file was to have: what it says itself, or else those up to its last one; where it was
/// cut short nobody knows.
std::optional<int> plannedSlicesOf(const RecordingFile& file)
{
    const int steps = file.recording.slices.back().step + 1;
    if (file.notes && file.notes->scan.plannedSlices)
        return std::max(steps, *file.notes->scan.plannedSlices);
    return file.damaged && !file.notes ? std::nullopt : std::optional(steps);
}

Result<OpenedSource> openFile(const std::string& path, double speed, const Clock& clock, const std::stop_token& stop)
{
    Result<RecordingFile> file = loadRecordingFile(path, {}, stop);
    if (!file)
        return tl::unexpected{file.error()};
    OpenedSource opened;
    const std::optional<int> planned = plannedSlicesOf(*file);
    if (file->damaged)
        opened.damage =
            InputDamage{static_cast<int>(file->recording.slices.size()), file->slicesLeftOut, file->warnings};
    opened.warnings = std::move(file->warnings);
    if (file->isImported) {
        opened.imported = std::move(file->notes);
    } else if (file->notes) {
        Result<std::vector<ParametersFrom>> parameters = readParameterEvents(file->notes->events, path);
        if (parameters)
            opened.parameters = std::move(*parameters);
        else
            opened.warnings.push_back(parameters.error().message);
        openProject(path, *file->notes, opened);
    }
    opened.source = std::make_shared<ReplayedRecording>(std::make_shared<const Recording>(std::move(file->recording)),
                                                        path.substr(path.rfind('/') + 1), clock, speed, planned);
    return opened;
}

}  // namespace

SimulationNoise defaultSimulationNoise()
{
    return simulationNoise("default").value_or(SimulationNoise{});
}

Result<OpenedSource> openSource(const SourceAddress& address, const SourceSetup& setup, const Clock& clock,
                                const std::stop_token& stop)
{
    switch (address.kind) {
        case SourceAddress::Kind::Simulation:
            return openRoom(address, setup.simulation, clock);
        case SourceAddress::Kind::Replay:
            return openFile(address.name, address.speed, clock, stop);
        case SourceAddress::Kind::Laser:
            return openLaserOnTiltUnit(address.laser, setup.nodding, clock, stop);
        case SourceAddress::Kind::File:
            break;
    }
    return openFile(address.name, 0.0, clock, stop);
}

}  // namespace planewright
