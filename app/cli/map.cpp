// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "app/cli/commands.h"
#include "app/cli/console.h"
#include "app/cli/map_floors.h"
#include "app/cli/map_report.h"
#include "app/cli/number_option.h"
#include "app/cli/output_files.h"
#include "app/cli/parameter_options.h"
#include "app/cli/progress.h"
#include "app/cli/recording_file.h"
#include "app/cli/stored_scan.h"
#include "app/files/cloud_file.h"
#include "app/files/file_kind.h"
#include "app/files/input_file.h"
#include "app/files/map_results.h"
#include "core/formats/floor_plan_svg.h"
#include "core/formats/planes_dxf.h"
#include "core/formats/planes_json.h"
#include "core/formats/recording_pwscan.h"
#include "core/formats/trajectory_tum.h"

namespace planewright {

namespace {

struct MapOptions {
    std::vector<std::string> inputs;
    std::string odometry, output, poses, floorPoses;
    std::vector<std::string> planes, floorPlans;
    double cutHeight = 1.0;  ///< above the floor [m]
    double scale = 100.0;    ///< of a plan as SVG
    bool noOdometry = false;
    bool noEdits = false;
    bool overwrite = false;
    ParameterOptions parameters;
};

constexpr std::array<std::string_view, 2> kPlanSuffixes{".dxf", ".svg"};

/// A scan of an input.
struct StopInput {
    std::string path;
    RecordingChoice choice;
    std::string name;
};

constexpr std::array<std::string_view, 7> kStopSuffixes{".csv", ".csv.gz", ".pwscan", ".pcd", ".ptx", ".3d", ".json"};

bool isResult(const std::string& path)
{
    return suffixOf(path, {".json"}, "").has_value();
}

Result<std::vector<StopInput>> stopInputs(const std::vector<std::string>& paths)
{
    for (const std::string& path : paths) {
        if (const auto known = suffixOf(path, kStopSuffixes, "a stop"); !known && !isCloudFile(path))
            return tl::unexpected{known.error()};
    }
    std::vector<StopInput> inputs;
    for (const std::string& path : paths) {
        if (isResult(path)) {
            inputs.push_back({path, {}, path});
            continue;
        }
        const auto scans = scansOfRecordingFile(path);
        if (!scans)
            return tl::unexpected{scans.error()};
        for (const RecordingChoice& choice : *scans)
            inputs.push_back({path, choice, choice.scan ? path + ", scan " + std::to_string(*choice.scan) : path});
    }
    return inputs;
}

/// All that a map is made from.
struct MapInput {
    std::vector<StopInput> inputs;
    std::vector<StopScan> stops;
    Parameters parameters;  ///< of the last extraction
    bool damaged = false;
};

template <class Read>
auto readFile(const std::string& path, Read read) -> decltype(read(std::declval<std::istream&>()))
{
    const auto input = openInput(path);
    if (!input)
        return tl::unexpected{input.error()};
    return read(**input);
}

Result<MapInput> extractStops(const MapOptions& options)
{
    auto inputs = stopInputs(options.inputs);
    if (!inputs)
        return tl::unexpected{inputs.error()};
    MapInput all{std::move(*inputs), {}, {}, false};
    Progress progress("extracting, stop");
    for (const StopInput& input : all.inputs) {
        progress.show(all.stops.size(), all.inputs.size());
        if (isResult(input.path)) {
            auto planes = readFile(input.path, [&](std::istream& in) { return readPlaneResultsJson(in, input.path); });
            if (!planes)
                return tl::unexpected{planes.error()};
            all.stops.push_back({input.name, 0, {}, std::move(*planes)});
            continue;
        }
        const auto file = readRecordingFile(input.path, input.choice);
        if (!file)
            return tl::unexpected{file.error()};
        auto extraction = extractStoredScan(*file, input.path, options.parameters, options.noEdits);
        if (!extraction)
            return tl::unexpected{extraction.error()};
        all.damaged = all.damaged || file->damaged;
        all.parameters = extraction->parameters;
        StopScan& stop = all.stops.emplace_back(StopScan{input.name, 0, {}, std::move(extraction->planes)});
        if (file->notes) {
            stop.floor = file->notes->scan.floor;
            stop.odometry = file->notes->scan.pose;
        }
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

/// Where each floor's frame is in that of the building, by its number.
Result<std::map<int, Pose>> floorFrames(const MapOptions& options, const std::vector<FloorScans>& floors)
{
    std::map<int, Pose> frames;
    if (options.floorPoses.empty()) {
        if (floors.size() > 1)
            return fail(ErrorCode::Usage, "the stops are on " + std::to_string(floors.size()) +
                                              " floors; say where each is with --floor-poses");
        return std::map<int, Pose>{{floors.front().floor, Pose{}}};
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

/// A scan as it was read, as one of the stops of a project.
Result<WrittenScan> stopScan(const StopInput& input, const StopScan& stop)
{
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
    return scan;
}

/// Opens outputs and writes them once the map is there.
class MapOutputs {
public:
    explicit MapOutputs(const MapOptions& options) : options_(options), files_(options.overwrite)
    {
        for (const std::string& input : options.inputs)
            files_.protect(input);
        for (const std::string* input : {&options.odometry, &options.floorPoses}) {
            if (!input->empty())
                files_.protect(*input);
        }
    }

    Result<void> open()
    {
        if (auto opened = open(options_.planes, kPlanesSuffixes, "the planes", planes_); !opened)
            return opened;
        if (auto opened = open(options_.floorPlans, kPlanSuffixes, "a floor plan", plans_); !opened)
            return opened;
        if (!options_.output.empty()) {
            if (const auto target = checkRecordingTarget(options_.output); !target)
                return tl::unexpected{target.error()};
            const auto result = std::ranges::find_if(options_.inputs, isResult);
            if (result != options_.inputs.end())
                return fail(ErrorCode::Usage, *result + ": has planes, but no slices for -o; give the recording");
            constexpr std::array<std::string_view, 1> kProject{kPwscanSuffix};
            if (auto opened = open({options_.output}, kProject, "the stops", project_); !opened)
                return opened;
        }
        if (options_.poses.empty())
            return {};
        const auto file = files_.open(options_.poses);
        if (!file)
            return tl::unexpected{file.error()};
        poses_ = *file;
        return {};
    }

    bool empty() const { return files_.empty(); }

    Result<void> write(const MapInput& input, const std::vector<MappedFloor>& floors)
    {
        const std::vector<PlaneResult> planes = planesOf(input, floors);
        const std::vector<StampedPose> poses = posesOf(floors);
        Result<void> done;
        const auto next = [&](OutputFile& file, const std::function<Result<void>(std::ostream&)>& writer) {
            if (done)
                done = file.write(writer);
        };
        for (const Output& output : planes_) {
            ScanResults results;
            results.parameters = input.parameters;
            results.planes = planes;
            next(*output.file, [&](std::ostream& out) { return planesWriter(output.suffix)(out, results); });
        }
        for (const Output& output : plans_)
            next(*output.file, [&](std::ostream& out) { return writePlan(out, output.suffix, planes, poses); });
        if (poses_ != nullptr)
            next(*poses_, [&](std::ostream& out) { return writeTrajectoryTum(out, poses); });
        for (const Output& output : project_)
            next(*output.file, [&](std::ostream& out) {
                return writeScansPwscan(out, input.stops.size(),
                                        [&](std::size_t i) { return stopScan(input.inputs[i], input.stops[i]); });
            });
        return done ? files_.publish() : done;
    }

private:
    struct Output {
        OutputFile* file;
        std::string_view suffix;
    };

    Result<void> open(const std::vector<std::string>& paths, std::span<const std::string_view> suffixes,
                      std::string_view what, std::vector<Output>& outputs)
    {
        for (const std::string& path : paths) {
            const auto suffix = suffixOf(path, suffixes, what);
            if (!suffix)
                return tl::unexpected{suffix.error()};
            const auto file = files_.open(path);
            if (!file)
                return tl::unexpected{file.error()};
            outputs.push_back({*file, *suffix});
        }
        return {};
    }

    static std::vector<PlaneResult> planesOf(const MapInput& input, const std::vector<MappedFloor>& floors)
    {
        std::vector<PlaneResult> planes;
        for (const MappedFloor& floor : floors) {
            for (PlaneResult& plane :
                 mapPlaneResults(floor.builder.map(), input.stops, floor.frame, static_cast<PlaneId>(planes.size())))
                planes.push_back(std::move(plane));
        }
        return planes;
    }

    static std::vector<StampedPose> posesOf(const std::vector<MappedFloor>& floors)
    {
        std::vector<StampedPose> poses;
        for (const MappedFloor& floor : floors) {
            for (const MapStop& stop : floor.builder.map().stops) {
                if (stop.isPlaced())
                    poses.push_back({static_cast<double>(stop.stop->id), floor.frame * stop.pose});
            }
        }
        std::ranges::sort(poses, {}, &StampedPose::time);
        return poses;
    }

    Result<void> writePlan(std::ostream& out, std::string_view suffix, const std::vector<PlaneResult>& planes,
                           const std::vector<StampedPose>& poses) const
    {
        const auto floor = floorHeight(planes);
        if (!floor)
            printWarning("no floor is found; the plan is cut at the height of the first stop's scanner");
        const double height = floor ? *floor + options_.cutHeight : 0.0;
        if (suffix == ".dxf")
            return writeFloorPlanDxf(out, planes, height);
        std::vector<Eigen::Vector2d> places;
        for (const StampedPose& pose : poses)
            places.emplace_back(pose.pose.translation.head<2>());
        return writeFloorPlanSvg(out, planes, height, options_.scale, places);
    }

    const MapOptions& options_;
    OutputFiles files_;
    std::vector<Output> planes_, plans_, project_;
    OutputFile* poses_ = nullptr;
};

Result<ExitCode> mapStops(const MapOptions& options)
{
    MapOutputs outputs(options);
    if (const auto opened = outputs.open(); !opened)
        return tl::unexpected{opened.error()};
    auto input = extractStops(options);
    if (!input)
        return tl::unexpected{input.error()};
    if (const auto taken = takeOdometry(options, input->stops); !taken)
        return tl::unexpected{taken.error()};
    const std::vector<FloorScans> floors = floorsOf(input->stops);
    const auto frames = floorFrames(options, floors);
    if (!frames)
        return tl::unexpected{frames.error()};
    const auto mapped = mapFloors(input->stops, floors, *frames);
    if (!mapped)
        return tl::unexpected{mapped.error()};
    for (const std::string& warning : mapWarnings(*mapped, input->stops))
        printWarning(warning);
    const auto done = outputs.empty() ? print(mapTable(*mapped, input->stops)) : outputs.write(*input, *mapped);
    if (!done)
        return tl::unexpected{done.error()};
    return input->damaged ? ExitCode::Damaged : ExitCode::Done;
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
    repeatable("--floor-plan", options->floorPlans, "plan seen from above as .dxf or .svg, repeatable");
    addNumber(command, "--cut-height", options->cutHeight, 0.0, 100.0,
              "height above the floor at which a plan is cut, in metres (default 1)");
    addNumber(command, "--plan-scale", options->scale, 1.0, 10000.0, "scale 1:N of a plan as .svg (default 100)");
    command
        .add_option("--floor-poses", options->floorPoses,
                    "where the frame of each floor is in the building (TUM format, the number of the floor as time)")
        ->type_name("FILE");
    command.add_flag("--no-edits", options->noEdits, "planes as they were found, without what was edited in a .pwscan");
    command.add_flag("--overwrite", options->overwrite, "replace output files that exist");
    addParameterOptions(command, options->parameters);
    command.callback([options, &chosen] { chosen = [options] { return mapStops(*options); }; });
}

}  // namespace planewright
