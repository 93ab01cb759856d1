// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "app/cli/commands.h"
#include "app/cli/console.h"
#include "app/cli/map_options.h"
#include "app/cli/map_outputs.h"
#include "app/cli/map_report.h"
#include "app/cli/number_option.h"
#include "app/cli/parameter_options.h"
#include "app/cli/progress.h"
#include "app/cli/stored_scan.h"
#include "app/files/input_file.h"
#include "app/mapping/map_edits.h"
#include "app/mapping/stop_inputs.h"
#include "core/formats/trajectory_tum.h"

namespace planewright {

namespace {

template <class Read>
auto readFile(const std::string& path, Read read) -> decltype(read(std::declval<std::istream&>()))
{
    const auto input = openInput(path);
    if (!input)
        return tl::unexpected{input.error()};
    return read(**input);
}

Result<MapInput> extractStops(const MapOptions& options, const MappingParameters& mapping,
                              std::vector<StopInput> inputs)
{
    MapInput all{std::move(inputs), {}, {}, {}, false};
    const auto choose = [&options](const RecordingFile& file, const std::string& path) {
        return parametersOverSteps(file, file.recording.description.scanner, path, -1, options.parameters);
    };
    Progress progress("extracting, stop");
    for (const StopInput& input : all.inputs) {
        progress.show(all.stops.size(), all.inputs.size());
        auto read = readStop(input, choose, mapping, options.noEdits);
        if (!read)
            return tl::unexpected{read.error()};
        for (const std::string& warning : read->warnings)
            printWarning(warning);
        all.damaged = all.damaged || read->damaged;
        if (read->parameters)
            all.parameters = *read->parameters;
        all.stops.push_back(std::move(read->scan));
    }
    return all;
}

/// Takes the poses of a trajectory, one for each stop in their order.
Result<void> takeOdometry(const MapOptions& options, std::vector<StopScan>& stops)
{
    if (options.noOdometry) {
        for (StopScan& stop : stops)
            stop.odometry.reset();
    }
    if (options.odometry.empty())
        return {};
    const auto poses =
        readFile(options.odometry, [&](std::istream& in) { return readTrajectoryTum(in, options.odometry); });
    if (!poses)
        return tl::unexpected{poses.error()};
    if (poses->size() != stops.size())
        return fail(ErrorCode::Unreadable, options.odometry + ": has " + std::to_string(poses->size()) +
                                               " poses, but there are " + std::to_string(stops.size()) +
                                               " stops; give one for each scan, in their order");
    for (std::size_t i = 0; i < stops.size(); ++i)
        stops[i].odometry = (*poses)[i].pose;
    return {};
}

/// Where each floor's frame is in that of the building, by its number. Floors that were placed by hand are moved there
/// when they have a map; the first of the others is at the building's own frame.
Result<std::map<int, Pose>> floorFrames(const MapOptions& options, const std::vector<FloorScans>& floors,
                                        const std::map<int, Pose>& byHand)
{
    std::map<int, Pose> frames;
    if (options.floorPoses.empty()) {
        std::size_t left = 0;
        for (const FloorScans& floor : floors) {
            const bool isByHand = std::ranges::any_of(
                floor.stops, [&](std::size_t stop) { return byHand.contains(static_cast<int>(stop)); });
            left += isByHand ? 0 : 1;
            frames[floor.floor] = Pose{};
        }
        if (left > 1)
            return fail(ErrorCode::Usage, "the stops are on " + std::to_string(floors.size()) +
                                              " floors; say where each is with --floor-poses");
        return frames;
    }
    const auto poses =
        readFile(options.floorPoses, [&](std::istream& in) { return readTrajectoryTum(in, options.floorPoses); });
    if (!poses)
        return tl::unexpected{poses.error()};
    for (const StampedPose& stamped : *poses) {
        if (stamped.time != std::round(stamped.time) || std::abs(stamped.time) > 1000.0)
            return fail(ErrorCode::Unreadable,
                        options.floorPoses + ": the first value of a line is the number of a floor");
        frames[static_cast<int>(stamped.time)] = stamped.pose;
    }
    for (const FloorScans& floor : floors) {
        if (!frames.contains(floor.floor))
            return fail(ErrorCode::Unreadable,
                        options.floorPoses + ": has no pose of floor " + std::to_string(floor.floor) + "; add it");
    }
    return frames;
}

Result<ExitCode> mapStops(MapOptions options)
{
    const auto mapping = takeMappingParameters(options.parameters);
    if (!mapping)
        return tl::unexpected{mapping.error()};
    auto inputs = stopInputs(options.inputs);
    if (!inputs)
        return tl::unexpected{inputs.error()};
    std::vector<std::string> problems;
    const auto edits =
        options.noEdits ? Result<std::vector<StopEdit>>(std::vector<StopEdit>{}) : mapEditsOf(options.inputs, problems);
    if (!edits)
        return tl::unexpected{edits.error()};
    const bool lacksEdits = !problems.empty();
    *inputs = withEdits(std::move(*inputs), *edits, problems);
    if (inputs->empty())
        return fail(ErrorCode::Usage, "edits leave no stop for the map; give --no-edits for all");
    for (const std::string& problem : problems)
        printWarning(problem);
    MapOutputs outputs(options);
    if (const auto opened = outputs.open(*inputs); !opened)
        return tl::unexpected{opened.error()};
    auto input = extractStops(options, *mapping, std::move(*inputs));
    if (!input)
        return tl::unexpected{input.error()};
    if (const auto taken = takeOdometry(options, input->stops); !taken)
        return tl::unexpected{taken.error()};
    input->edits = *edits;
    const std::vector<FloorScans> floors = floorsOf(input->stops);
    const std::map<int, Pose> byHand =
        options.floorPoses.empty() ? floorsByHand(input->stops, *edits) : std::map<int, Pose>{};
    const auto frames = floorFrames(options, floors, byHand);
    if (!frames)
        return tl::unexpected{frames.error()};
    Progress progress("mapping, stop");
    const auto show = [&progress](std::size_t done, std::size_t all) { progress.show(done, all); };
    auto mapped = mapFloors(input->stops, floors, *frames, {*mapping, *edits, show, {}});
    if (!mapped)
        return tl::unexpected{mapped.error()};
    placeFloors(*mapped, byHand);
    for (const std::string& warning : mapWarnings(*mapped, input->stops))
        printWarning(warning);
    const auto done = outputs.empty() ? print(mapTable(*mapped, input->stops)) : outputs.write(*input, *mapped);
    if (!done)
        return tl::unexpected{done.error()};
    return input->damaged || lacksEdits ? ExitCode::Damaged : ExitCode::Done;
}

}  // namespace

void addMapCommand(CLI::App& program, Command& chosen)
{
    CLI::App& command = *program.add_subcommand("map", "several stops into one map of planes");
    auto options = std::make_shared<MapOptions>();
    command
        .add_option("INPUT", options->inputs,
                    "recordings (.csv, .csv.gz), a stop for each scan of a .pwscan or .ptx, other clouds (.pcd, .3d or "
                    "a folder of these), or planes that extract wrote (.json)")
        ->required();
    command
        .add_option("--odometry", options->odometry,
                    "where wheels tell the stops to be: a pose for each in their order (TUM format)")
        ->type_name("FILE");
    command.add_flag("--no-odometry", options->noOdometry,
                     "place stops by their planes alone, whatever a .pwscan says");
    command.add_option("-o", options->output, "all stops as one .pwscan")->type_name("FILE");
    const auto repeatable = [&](const std::string& name, std::vector<std::string>& files, const std::string& help) {
        command.add_option(name, files, help)->type_name("FILE")->allow_extra_args(false);
    };
    repeatable("--planes", options->planes, "planes of the map as .csv, .json, .ply, .obj or .dxf, repeatable");
    command.add_option("--poses", options->poses, "corrected poses of the stops (TUM format)")->type_name("FILE");
    repeatable("--floor-plan", options->floorPlans,
               "plan seen from above as .dxf or .svg, repeatable; of several floors a file each, as in "
               "plan-floor-2.dxf");
    addNumber(command, "--cut-height", options->cutHeight, 0.0, 100.0,
              "height above the floor at which a plan is cut, in metres (default 1)");
    addNumber(command, "--plan-scale", options->scale, 1.0, 10000.0, "scale 1:N of a plan as .svg (default 100)");
    command
        .add_option("--floor-poses", options->floorPoses,
                    "where the frame of each floor is in the building (TUM format, the number of the floor as time)")
        ->type_name("FILE");
    command.add_flag("--no-edits", options->noEdits,
                     "planes and stops as they were recorded, without what was edited in a .pwscan");
    command.add_flag("--overwrite", options->overwrite, "replace output files that exist");
    addParameterOptions(command, options->parameters);
    command.callback([options, &chosen] { chosen = [options] { return mapStops(*options); }; });
}

}  // namespace planewright
