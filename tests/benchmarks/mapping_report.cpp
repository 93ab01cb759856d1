// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

// How well maps come out of scans: floors of a simulated building are scanned stop by stop, each scan is extracted, and
// the map of what was found is held against the truth.

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <Eigen/Cholesky>

#include "core/mapping/map_builder.h"
#include "core/simulation/building.h"
#include "core/types/angle.h"
#include "tests/benchmarks/scanned_floor.h"
#include "tests/benchmarks/scoring.h"
#include "tests/core/mapping/map_score.h"

using namespace planewright;

namespace {

struct Options {
    int stops = 20;
    std::uint64_t seeds = 10;
    MappingParameters parameters;
};

/// e'C⁻¹e of the map's planes, C their bound, errors in the first stop's frame.
std::vector<double> planeErrors(const BuildingMap& map, const ScannedFloor& floor)
{
    const std::vector<std::vector<int>> pieces = piecesOf(floor);
    const std::vector<Eigen::Matrix3d> bounds = boundsOf(floor, pieces);
    std::vector<double> errors;
    const Pose frame = floor.stops.front().truth;
    for (const MapPlane& plane : map.planes) {
        if (plane.sightings.empty())
            continue;
        const auto [stop, i] = plane.sightings.front();
        if (!floor.sides[stop][i])
            continue;
        const auto number = static_cast<std::size_t>(floor.stops[stop].planes[i]);
        const OrientedPlane& truth = floor.planes[number];
        const Eigen::Vector3d normal = frame.rotation * plane.parameters.normal;
        Eigen::Vector3d error;
        error.head<2>() = floor.tangents[number].transpose() * (normal - truth.normal);
        error.z() = plane.parameters.distance + normal.dot(frame.translation) - truth.distance;
        errors.push_back(error.dot(bounds[static_cast<std::size_t>(pieces[stop][i])].ldlt().solve(error)));
    }
    return errors;
}

void append(MapScore& all, const MapScore& score)
{
    all.wrong += score.wrong;
    all.possible += score.possible;
    all.made += score.made;
    all.open += score.open;
    for (const auto part : {&MapScore::shifts, &MapScore::turns, &MapScore::poseErrors, &MapScore::planeErrors})
        (all.*part).insert((all.*part).end(), (score.*part).begin(), (score.*part).end());
}

void printRow(const char* name, const MapScore& score, const std::vector<double>& squared, std::size_t placed)
{
    std::printf("| %s | %zu | %.1f | %.3f | %d | %d | %.1f | %d | %.2f | %.2f | %.2f |\n", name, placed,
                1000.0 * meanOf(score.shifts), toDegrees(meanOf(score.turns)), score.wrong, score.possible,
                score.possible > 0 ? 100.0 * score.made / score.possible : 100.0, score.open,
                meanOf(score.poseErrors) / 6.0, meanOf(score.planeErrors) / 3.0, errorOverBound(squared));
    std::fflush(stdout);
}

int report(const Options& options)
{
    std::puts(
        "| seed | placed | place [mm] | attitude [deg] | wrong | possible | made [%] | open | poses e'C⁻¹e / 6 "
        "| planes e'C⁻¹e / 3 | planes / bound |");
    std::puts("| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |");
    MapScore all;
    std::vector<double> allSquared;
    std::size_t allPlaced = 0;
    for (std::uint64_t seed = 1; seed <= options.seeds; ++seed) {
        const SimulatedBuilding building(1, seed);
        const ScannedFloor floor = scanFloor(building, building.route(options.stops), seed);
        MapBuilder builder(options.parameters);
        for (const SimulatedStop& stop : floor.stops) {
            if (const auto joined = builder.join(stop.stop); !joined) {
                std::fprintf(stderr, "mapping_report: seed %d: %s\n", static_cast<int>(seed),
                             joined.error().message.c_str());
                return 1;
            }
        }
        if (const auto adjusted = builder.adjust(); !adjusted) {
            std::fprintf(stderr, "mapping_report: seed %d: %s\n", static_cast<int>(seed),
                         adjusted.error().message.c_str());
            return 1;
        }
        const MapScore score = scoreMap(builder.map(), floor.stops, floor.planes);
        const std::vector<double> squared = planeErrors(builder.map(), floor);
        const auto placed = static_cast<std::size_t>(
            std::ranges::count_if(builder.map().stops, [](const MapStop& stop) { return stop.isPlaced(); }));
        printRow(std::to_string(seed).c_str(), score, squared, placed);
        append(all, score);
        allSquared.insert(allSquared.end(), squared.begin(), squared.end());
        allPlaced += placed;
    }
    printRow("all", all, allSquared, allPlaced);
    return 0;
}

}  // namespace

int main(int argc, char** argv)
{
    CLI::App program{"How well the map of a simulated floor comes out of scans of its stops", "mapping_report"};
    Options options;
    program.add_option("--stops", options.stops, "once round the floor")
        ->capture_default_str()
        ->check(CLI::Range(2, 70));
    program.add_option("--seeds", options.seeds, "floors, by seed from 1")
        ->capture_default_str()
        ->check(CLI::Range(1, 1000));
    program.add_option("--flatness", options.parameters.flatness, "how uneven walls are [m]")->capture_default_str();
    CLI11_PARSE(program, argc, argv);
    return report(options);
}
