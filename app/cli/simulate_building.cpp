// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/cli/simulate_building.h"

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "app/cli/output_files.h"
#include "app/cli/progress.h"
#include "app/cli/recording_file.h"
#include "app/files/file_kind.h"
#include "core/formats/planes_csv.h"
#include "core/formats/recording_pwscan.h"
#include "core/formats/trajectory_tum.h"
#include "core/simulation/building.h"

namespace planewright {

namespace {

constexpr double kStopsAFloor = 17.5;
constexpr int kUsualFloors = 4;

/// The pose of a floor's frame in that of the lowest floor.
Pose floorPose(int floor)
{
    return {Eigen::Quaterniond::Identity(), {0.0, 0.0, floor * SimulatedBuilding::kStoreyHeight}};
}

/// The true planes of all floors in the frame of the first stop, with the returns that all scans have of each.
std::vector<PlaneResult> truthOf(const SimulatedBuilding& building, const Pose& first,
                                 const std::vector<std::map<int, int>>& returns)
{
    std::vector<PlaneResult> planes;
    for (int floor = 0; floor < building.floors(); ++floor) {
        const Scene scene = building.sceneAt(floor, floorPose(floor).inverse() * first);
        const std::map<int, int>& seen = returns[static_cast<std::size_t>(floor)];
        for (const TruePlane& plane : scene.planes) {
            const auto count = seen.find(plane.id);
            planes.push_back(knownPlane(static_cast<PlaneId>(planes.size()),
                                        "floor " + std::to_string(floor) + ": " + plane.name, plane.normal,
                                        plane.distance, count == seen.end() ? 0 : count->second));
        }
    }
    return planes;
}

std::vector<StampedPose> truePoses(const std::vector<BuildingStop>& route)
{
    const Pose toFirst = route.front().pose.inverse();
    std::vector<StampedPose> poses;
    for (const BuildingStop& stop : route)
        poses.push_back({static_cast<double>(poses.size()), toFirst * floorPose(stop.floor) * stop.pose});
    return poses;
}

}  // namespace

Result<ExitCode> simulateBuilding(const SimulateOptions& options)
{
    const Result<SimulationNoise> noise = noiseOf(options);
    if (!noise)
        return tl::unexpected{noise.error()};
    const Result<AcquisitionSettings> settings = settingsOf(options);
    if (!settings)
        return tl::unexpected{settings.error()};
    if (const auto target = suffixOf(options.output, {kPwscanSuffix}, "a recording of several stops"); !target)
        return tl::unexpected{target.error()};
    if (const auto target = checkRecordingTarget(options.output); !target)
        return tl::unexpected{target.error()};
    if (!options.truthLabels.empty())
        return fail(ErrorCode::Usage, "--truth-labels: a building has several scans; use --truth");
    const int floors = options.floors > 0 ? options.floors : kUsualFloors;
    const int stops = options.stops > 0 ? options.stops : static_cast<int>(kStopsAFloor * floors);
    if (stops < floors)
        return fail(ErrorCode::Usage, "--stops: " + std::to_string(floors) + " floors need a stop each");

    OutputFiles files{options.overwrite};
    std::vector<OutputFile*> outputs;
    for (const std::string* path : {&options.output, &options.truth, &options.truthPoses}) {
        if (path->empty()) {
            outputs.push_back(nullptr);
            continue;
        }
        const auto file = files.open(*path);
        if (!file)
            return tl::unexpected{file.error()};
        outputs.push_back(*file);
    }

    const SimulatedBuilding building(floors, options.seed);
    const std::vector<BuildingStop> route = building.route(stops);
    std::vector<std::map<int, int>> returns(static_cast<std::size_t>(floors));
    Progress progress("simulating, stop");
    const auto scanOf = [&](std::size_t number) -> Result<WrittenScan> {
        const BuildingStop& stop = route[number];
        progress.show(number, route.size());
        const std::uint64_t seed = options.seed + 0x9e3779b97f4a7c15U * (number + 1);  // each stop's noise is its own
        SimulatedScan scan =
            simulatedScan(building.sceneAt(stop.floor, stop.pose), *settings, *noise, seed, [](int /*slices*/) {});
        for (const std::vector<int>& labels : scan.labels) {
            for (const int label : labels)
                ++returns[static_cast<std::size_t>(stop.floor)][label];
        }
        WrittenScan written{std::move(scan.recording), {}};
        written.notes.scan.state = ScanState::Complete;
        written.notes.scan.name = "stop " + std::to_string(number + 1);
        written.notes.scan.floor = stop.floor;
        written.notes.scan.pose = stop.odometry;
        return written;
    };
    Result<void> written =
        outputs[0]->write([&](std::ostream& out) { return writeScansPwscan(out, route.size(), scanOf); });
    if (written && outputs[1] != nullptr)
        written = outputs[1]->write(
            [&](std::ostream& out) { return writePlanesCsv(out, truthOf(building, route.front().pose, returns)); });
    if (written && outputs[2] != nullptr)
        written = outputs[2]->write([&](std::ostream& out) { return writeTrajectoryTum(out, truePoses(route)); });
    if (written)
        written = files.publish();
    if (!written)
        return tl::unexpected{written.error()};
    return ExitCode::Done;
}

}  // namespace planewright
