// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/window/building_maker.h"

#include <algorithm>
#include <array>
#include <utility>

#include "app/window/shown_building_of.h"

namespace planewright {

namespace {

/// Where the frame of each floor is, by odometry; at the lowest one's where that is not known.
std::map<int, Pose> framesByOdometry(const std::vector<StopScan>& stops, const std::vector<FloorScans>& floors)
{
    std::map<int, Pose> frames;
    const auto& lowest = stops[floors.front().stops.front()].odometry;
    for (const FloorScans& floor : floors) {
        const auto& first = stops[floor.stops.front()].odometry;
        frames[floor.floor] = lowest && first ? lowest->inverse() * *first : Pose{};
    }
    return frames;
}

std::vector<StopEdit> editsOf(const BuildingRequest& request)
{
    std::vector<StopEdit> edits;
    for (const MapEdit& edit : request.edits)
        edits.push_back({request.path, edit});
    return edits;
}

/// The stops that edits take out.
std::vector<StopInput> omittedOf(const std::vector<StopInput>& all, const std::vector<StopInput>& left)
{
    std::vector<StopInput> omitted;
    for (const StopInput& input : all) {
        if (std::ranges::none_of(left, [&](const StopInput& other) { return other.choice.scan == input.choice.scan; }))
            omitted.push_back(input);
    }
    return omitted;
}

}  // namespace

Result<std::vector<StopScan>> BuildingMaker::stopsOf(const std::vector<StopInput>& inputs,
                                                     const BuildingRequest& request, const Progress& progress,
                                                     const std::stop_token& stop, BuiltMap& built)
{
    if (std::exchange(path_, request.path) != request.path)
        read_.clear();
    if (request.readAgain)
        read_.erase(*request.readAgain);
    const auto choose = [&request](const RecordingFile& file, const std::string& path) {
        auto stored = file.notes ? readParameterEvents(file.notes->events, path)
                                 : Result<std::vector<ParametersFrom>>(std::vector<ParametersFrom>{});
        if (!stored)
            return stored;
        return request.parameters(file.recording.description.scanner, std::move(*stored));
    };
    std::vector<StopScan> stops;
    for (const StopInput& input : inputs) {
        const int scan = input.choice.scan.value_or(0);
        if (!read_.contains(scan)) {
            progress("extracting stop", stops.size(), inputs.size());
            auto read = readStop(input, choose, {}, false, stop);
            if (!read)
                return tl::unexpected{read.error()};
            read_[scan] = std::move(*read);
        }
        const ReadStop& read = read_[scan];
        built.problems.insert(built.problems.end(), read.warnings.begin(), read.warnings.end());
        if (read.parameters)
            built.parameters = *read.parameters;
        StopScan& taken = stops.emplace_back(read.scan);
        taken.odometry = input.odometry;
    }
    return stops;
}

Result<std::shared_ptr<const BuiltMap>> BuildingMaker::make(const BuildingRequest& request, const Progress& progress,
                                                            const std::stop_token& stop)
{
    auto built = std::make_shared<BuiltMap>();
    const auto inputs = stopInputs({request.path});
    if (!inputs)
        return tl::unexpected{inputs.error()};
    const std::vector<StopEdit> edits = editsOf(request);
    std::vector<StopInput> left = withEdits(*inputs, edits, built->problems);
    if (left.empty())
        return fail(ErrorCode::Usage, "Every stop is taken out of the map; take one in again.");
    const std::vector<StopInput> omitted = omittedOf(*inputs, left);
    const std::size_t all = left.size();
    if (request.until)
        left.resize(std::clamp<std::size_t>(static_cast<std::size_t>(std::max(*request.until, 1)), 1, all));
    auto stops = stopsOf(left, request, progress, stop, *built);
    if (!stops)
        return tl::unexpected{stops.error()};
    built->stops = std::move(*stops);
    const std::vector<FloorScans> floors = floorsOf(built->stops);
    MappingPlan plan;
    plan.edits = edits;
    plan.progress = [&progress](std::size_t done, std::size_t count) { progress("mapping stop", done, count); };
    plan.stop = stop;
    auto mapped = mapFloors(built->stops, floors, framesByOdometry(built->stops, floors), plan);
    if (!mapped)
        return tl::unexpected{mapped.error()};
    placeFloors(*mapped, floorsByHand(built->stops, edits));
    built->floors = std::move(*mapped);
    built->planes = planesOfFloors(built->floors, built->stops);
    for (const MappedFloor& floor : built->floors) {
        built->problems.insert(built->problems.end(), floor.problems.begin(), floor.problems.end());
        built->plans.push_back(floorPlanOf(floor, built->stops, 0.0));
    }
    built->shown = shownMapOf(*built, omitted, request.edits, all);
    return built;
}

}  // namespace planewright
