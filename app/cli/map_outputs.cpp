// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/cli/map_outputs.h"

#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <set>
#include <utility>

#include "app/cli/console.h"
#include "app/cli/recording_file.h"
#include "app/files/file_kind.h"
#include "app/files/scan_results.h"
#include "app/mapping/floor_plan.h"
#include "core/formats/recording_pwscan.h"
#include "core/formats/trajectory_tum.h"

namespace planewright {

namespace {

/// What is kept as edits of a stop, in a project whose scans are the stops in their order, from 1: its matches by hand,
/// and where its floor was placed by it.
std::vector<StoredMapEdit> keptEdits(const MapInput& all, std::size_t number)
{
    const StopScan& stop = all.stops[number];
    std::vector<StoredMapEdit> kept;
    for (const StopEdit& each : all.edits) {
        MapEdit edit = each.edit;
        if (edit.kind != MapEdit::Kind::Match || each.path != stop.path || edit.scan != stop.scan)
            continue;
        if (edit.as) {
            const auto other = std::ranges::find_if(
                all.stops, [&](const StopScan& scan) { return scan.path == stop.path && scan.scan == edit.as->scan; });
            if (other == all.stops.end())
                continue;
            edit.as->scan = static_cast<int>(other - all.stops.begin()) + 1;
        }
        kept.push_back({0, edit, false});
    }
    const std::map<int, Pose> floors = floorsByHand(all.stops, all.edits);
    if (const auto place = floors.find(static_cast<int>(number)); place != floors.end()) {
        MapEdit floor;
        floor.kind = MapEdit::Kind::Floor;
        floor.scan = stop.scan;
        floor.place = place->second;
        kept.push_back({0, floor, false});
    }
    return kept;
}

/// A scan as it was read, as one of the stops of a project: order and odometry are those of the map.
Result<WrittenScan> stopScan(const MapInput& all, std::size_t number)
{
    const StopInput& input = all.inputs[number];
    const StopScan& stop = all.stops[number];
    auto file = readRecordingFile(input.path, input.choice);
    if (!file)
        return tl::unexpected{file.error()};
    WrittenScan scan{std::move(file->recording), {}};
    if (file->notes) {
        scan.notes = std::move(*file->notes);
    } else {
        scan.notes.scan.state = ScanState::Complete;
        scan.notes.scan.name = input.path;
    }
    scan.notes.scan.floor = stop.floor;
    scan.notes.scan.pose = stop.odometry;
    scan.notes.mapEdits = keptEdits(all, number);
    return scan;
}

}  // namespace

MapOutputs::MapOutputs(const MapOptions& options) : options_(options), files_(options.overwrite)
{
    for (const std::string& input : options.inputs)
        files_.protect(input);
    for (const std::string* input : {&options.odometry, &options.floorPoses}) {
        if (!input->empty())
            files_.protect(*input);
    }
}

Result<void> MapOutputs::open(const std::string& path, std::span<const std::string_view> suffixes,
                              std::string_view what, std::vector<Output>& outputs, int floor)
{
    const auto suffix = suffixOf(path, suffixes, what);
    if (!suffix)
        return tl::unexpected{suffix.error()};
    const auto file = files_.open(path);
    if (!file)
        return tl::unexpected{file.error()};
    outputs.push_back({*file, *suffix, floor});
    return {};
}

Result<void> MapOutputs::openPlans(std::span<const StopInput> inputs)
{
    std::set<int> floors;
    for (const StopInput& input : inputs)
        floors.insert(input.floor);
    for (const std::string& path : options_.floorPlans) {
        if (const auto suffix = suffixOf(path, kMapPlanSuffixes, "a floor plan"); !suffix)
            return tl::unexpected{suffix.error()};
        for (const int floor : floors) {
            const std::string target = floors.size() > 1 ? floorPlanPath(path, floor) : path;
            if (auto opened = open(target, kMapPlanSuffixes, "a floor plan", plans_, floor); !opened)
                return opened;
        }
    }
    return {};
}

Result<void> MapOutputs::openProject()
{
    if (options_.output.empty())
        return {};
    if (const auto target = checkRecordingTarget(options_.output); !target)
        return tl::unexpected{target.error()};
    const auto result = std::ranges::find_if(options_.inputs, isPlanesResult);
    if (result != options_.inputs.end())
        return fail(ErrorCode::Usage, *result + ": has planes, but no slices for -o; give the recording");
    constexpr std::array<std::string_view, 1> kProject{kPwscanSuffix};
    return open(options_.output, kProject, "the stops", project_);
}

Result<void> MapOutputs::open(std::span<const StopInput> inputs)
{
    for (const std::string& path : options_.planes) {
        if (auto opened = open(path, kPlanesSuffixes, "the planes", planes_); !opened)
            return opened;
    }
    if (auto opened = openPlans(inputs); !opened)
        return opened;
    if (auto opened = openProject(); !opened || options_.poses.empty())
        return opened;
    const auto file = files_.open(options_.poses);
    if (!file)
        return tl::unexpected{file.error()};
    poses_ = *file;
    return {};
}

Result<void> MapOutputs::write(const Output& plan, std::span<const MappedFloor> floors,
                               std::span<const StopScan> stops) const
{
    const auto floor = std::ranges::find(floors, plan.floor, &MappedFloor::floor);
    const FloorPlan drawn = floorPlanOf(*floor, stops, options_.cutHeight);
    if (!drawn.isFloorKnown)
        printWarning("no floor is found" + (floors.size() > 1 ? " on floor " + std::to_string(plan.floor) : "") +
                     "; the plan is cut at the height of the first stop's scanner");
    return plan.file->write([&](std::ostream& out) { return writeFloorPlan(out, plan.suffix, drawn, options_.scale); });
}

Result<void> MapOutputs::write(const MapInput& input, std::span<const MappedFloor> floors)
{
    Result<void> done;
    const auto next = [&](OutputFile& file, const std::function<Result<void>(std::ostream&)>& writer) {
        if (done)
            done = file.write(writer);
    };
    ScanResults results;
    results.parameters = input.parameters;
    results.planes = planesOfFloors(floors, input.stops);
    for (const Output& output : planes_)
        next(*output.file, [&](std::ostream& out) { return planesWriter(output.suffix)(out, results); });
    for (const Output& output : plans_) {
        if (done)
            done = write(output, floors, input.stops);
    }
    if (poses_ != nullptr)
        next(*poses_, [&](std::ostream& out) { return writeTrajectoryTum(out, posesOfFloors(floors)); });
    for (const Output& output : project_)
        next(*output.file, [&](std::ostream& out) {
            return writeScansPwscan(out, input.stops.size(), [&](std::size_t i) { return stopScan(input, i); });
        });
    return done ? files_.publish() : done;
}

}  // namespace planewright
