// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

// How well maps come out of scans: floors of a simulated building are scanned stop by stop, each scan is extracted, and
// the map of what was found is held against the truth.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>
#include <Eigen/Cholesky>
#include <Eigen/LU>

#include "core/formats/labels.h"
#include "core/geometry/tangents.h"
#include "core/mapping/map_builder.h"
#include "core/params/presets.h"
#include "core/pipeline/plane_extractor.h"
#include "core/simulation/building.h"
#include "core/simulation/nodding_scanner.h"
#include "core/types/angle.h"
#include "tests/benchmarks/scoring.h"
#include "tests/core/mapping/map_score.h"

using namespace planewright;

namespace {

struct Options {
    int stops = 20;
    std::uint64_t seeds = 10;
    MappingParameters parameters;
};

/// A surface seen from one of its sides: the id of its true plane, and whether its normal is turned round.
using Side = std::pair<int, bool>;
using Tangents = Eigen::Matrix<double, 3, 2>;

/// A floor as it was scanned and found.
struct ScannedFloor {
    std::vector<SimulatedStop> stops;
    std::vector<OrientedPlane> planes;  ///< in the frame of the floor
    std::vector<Tangents> tangents;     ///< of each plane
    /// Of each stop: what its points tell of the planes that it saw, about these tangents and d.
    std::vector<std::map<int, Eigen::Matrix3d>> information;
};

/// The true plane that most returns of each found plane lie on; kNoTruePlane where none has half of them.
std::map<PlaneId, int> truthOf(const Snapshot& found, const SimulatedScan& scan)
{
    const Labels labels = labelsOf(found, scan.recording);
    std::map<PlaneId, std::map<int, int>> counts;
    for (std::size_t k = 0; k < labels.size(); ++k) {
        for (std::size_t i = 0; i < labels[k].size(); ++i) {
            if (labels[k][i] != kNoPlane)
                ++counts[labels[k][i]][scan.labels[k][i]];
        }
    }
    std::map<PlaneId, int> truth;
    for (const auto& [id, hits] : counts) {
        int points = 0;
        std::pair<int, int> most{0, kNoTruePlane};
        for (const auto& [plane, hit] : hits) {
            points += hit;
            most = std::max(most, {hit, plane});
        }
        truth[id] = 2 * most.first > points && most.second >= 0 ? most.second : kNoTruePlane;
    }
    return truth;
}

OrientedPlane inFloor(const Eigen::Vector3d& normal, double distance, const Pose& pose)
{
    const Eigen::Vector3d turned = pose.rotation * normal;
    return {turned, distance + turned.dot(pose.translation)};
}

/// What a stop's points tell of a plane, as information about these tangents in the floor's frame, and d.
Eigen::Matrix3d inFloor(const Eigen::Matrix3d& information, const TruePlane& plane, const Pose& pose,
                        const Tangents& tangents)
{
    const Eigen::Matrix3d rotation = pose.rotation.toRotationMatrix();
    const Tangents turned = rotation * tangentsOf(plane.normal);
    Eigen::Matrix3d jacobian = Eigen::Matrix3d::Identity();
    jacobian.topLeftCorner<2, 2>() = tangents.transpose() * turned;
    jacobian.bottomLeftCorner<1, 2>() = pose.translation.transpose() * turned;
    const Eigen::Matrix3d back = jacobian.inverse();
    return back.transpose() * information * back;
}

bool isSamePlane(const OrientedPlane& a, const OrientedPlane& b)
{
    return (a.normal - b.normal).norm() < 1e-9 && std::abs(a.distance - b.distance) < 1e-9;
}

ScannedFloor scanFloor(const SimulatedBuilding& building, const std::vector<BuildingStop>& route, std::uint64_t seed)
{
    const SimulationNoise noise = *simulationNoise("default");
    const AcquisitionSettings settings = *acquisitionSettings("table8");
    Parameters parameters;
    apply(*findPreset(methodPresets(), "precise"), parameters);
    const Scene reference = building.sceneAt(0, route.front().pose);
    ScannedFloor floor;
    std::map<Side, int> numbers;
    // Doors of one wall, say, lie in one plane: it has one number.
    const auto numberOf = [&](const Side& side, const OrientedPlane& plane) {
        const auto same =
            std::ranges::find_if(floor.planes, [&](const OrientedPlane& other) { return isSamePlane(other, plane); });
        const auto [place, isNew] = numbers.try_emplace(side, static_cast<int>(same - floor.planes.begin()));
        if (isNew && same == floor.planes.end()) {
            floor.planes.push_back(plane);
            floor.tangents.push_back(tangentsOf(plane.normal));
        }
        return place->second;
    };
    for (std::size_t n = 0; n < route.size(); ++n) {
        const Pose& pose = route[n].pose;
        const Scene scene = building.sceneAt(0, pose);
        const SimulatedScan scan = simulate(scene, settings, noise, seed + 0x9e3779b97f4a7c15U * (n + 1));
        PlaneExtractor extractor(sensorOf(scan.recording.description), parameters);
        for (const ScanSlice& slice : scan.recording.slices)
            extractor.advance(slice);
        const auto found = extractor.finish();

        const std::vector<Eigen::Matrix3d> information = trueInformation(scene, scan, noise);
        std::vector<int> ofTruth;
        auto& seen = floor.information.emplace_back();
        for (const TruePlane& plane : scene.planes) {
            const OrientedPlane there = inFloor(plane.normal, plane.distance, pose);
            const TruePlane& first = reference.planes[static_cast<std::size_t>(plane.id)];
            const bool isTurned = there.normal.dot(route.front().pose.rotation * first.normal) < 0.0;
            ofTruth.push_back(numberOf({plane.id, isTurned}, there));
            const Eigen::Matrix3d& told = information[static_cast<std::size_t>(plane.id)];
            if (told(2, 2) <= 0.0)
                continue;
            const Tangents& tangents = floor.tangents[static_cast<std::size_t>(ofTruth.back())];
            seen.try_emplace(ofTruth.back(), Eigen::Matrix3d::Zero()).first->second +=
                inFloor(told, plane, pose, tangents);
        }
        SimulatedStop stop;
        stop.truth = pose;
        stop.stop.id = static_cast<int>(n);
        if (n > 0) {
            const Pose motion = route[n - 1].odometry.inverse() * route[n].odometry;
            stop.stop.odometry = Motion{motion, odometryCovariance(motion, {})};
        }
        const std::map<PlaneId, int> truth = truthOf(*found, scan);
        for (const auto& plane : found->planes) {
            stop.stop.planes.push_back(observedPlane(*plane, outlineOf(*plane, found->segments)));
            const auto known = truth.find(plane->id);
            if (known != truth.end() && known->second != kNoTruePlane) {
                stop.planes.push_back(ofTruth[static_cast<std::size_t>(known->second)]);
                continue;
            }
            // What is no true plane is nobody's partner.
            stop.planes.push_back(static_cast<int>(floor.planes.size()));
            floor.planes.push_back(inFloor(plane->normal, plane->distance, pose));
            floor.tangents.push_back(tangentsOf(floor.planes.back().normal));
        }
        floor.stops.push_back(std::move(stop));
    }
    return floor;
}

/// The Cramér-Rao bound of the planes' parameters about the floor's tangents and d, by all points of all stops and
/// odometry together, with the poses unknown but the first: what nobody saw has none.
std::vector<std::optional<Eigen::Matrix3d>> boundsOf(const ScannedFloor& floor)
{
    std::vector<Eigen::Index> columns(floor.planes.size(), -1);
    Eigen::Index size = 6 * static_cast<Eigen::Index>(floor.stops.size() - 1);
    for (const auto& seen : floor.information) {
        for (const auto& [plane, information] : seen) {
            Eigen::Index& column = columns[static_cast<std::size_t>(plane)];
            if (column >= 0)
                continue;
            column = size;
            size += 3;
        }
    }
    Eigen::MatrixXd all = Eigen::MatrixXd::Zero(size, size);
    const auto poseColumn = [](std::size_t stop) { return 6 * static_cast<Eigen::Index>(stop - 1); };
    for (std::size_t k = 0; k < floor.stops.size(); ++k) {
        const Pose& pose = floor.stops[k].truth;
        for (const auto& [plane, information] : floor.information[k]) {
            const Eigen::Index at = columns[static_cast<std::size_t>(plane)];
            all.block<3, 3>(at, at) += information;
            if (k == 0)
                continue;
            UncertainPlane there;
            there.normal = floor.planes[static_cast<std::size_t>(plane)].normal;
            there.distance = floor.planes[static_cast<std::size_t>(plane)].distance;
            there.tangents = floor.tangents[static_cast<std::size_t>(plane)];
            const Matrix3x6d byPose = -poseJacobian(there, pose);
            const Eigen::Index of = poseColumn(k);
            all.block<6, 6>(of, of) += byPose.transpose() * information * byPose;
            all.block<3, 6>(at, of) += information * byPose;
            all.block<6, 3>(of, at) += byPose.transpose() * information;
        }
        if (k == 0)
            continue;
        // Of the motion from the stop before: what its error adds to the pose of the one, less what the other's does.
        const Matrix6d motion = turnedBy(floor.stops[k - 1].truth.rotation, floor.stops[k].stop.odometry->covariance);
        const Matrix6d known = motion.inverse();
        const Matrix6d carried = -carriedBy(pose.translation - floor.stops[k - 1].truth.translation);
        all.block<6, 6>(poseColumn(k), poseColumn(k)) += known;
        if (k == 1)
            continue;
        all.block<6, 6>(poseColumn(k - 1), poseColumn(k - 1)) += carried.transpose() * known * carried;
        all.block<6, 6>(poseColumn(k), poseColumn(k - 1)) += known * carried;
        all.block<6, 6>(poseColumn(k - 1), poseColumn(k)) += carried.transpose() * known;
    }
    const Eigen::MatrixXd covariance = all.ldlt().solve(Eigen::MatrixXd::Identity(size, size));
    std::vector<std::optional<Eigen::Matrix3d>> bounds(floor.planes.size());
    for (std::size_t plane = 0; plane < bounds.size(); ++plane) {
        if (columns[plane] >= 0)
            bounds[plane] = covariance.block<3, 3>(columns[plane], columns[plane]);
    }
    return bounds;
}

/// e'C⁻¹e of the map's planes, C their bound, errors in the first stop's frame.
std::vector<double> planeErrors(const BuildingMap& map, const ScannedFloor& floor)
{
    const std::vector<std::optional<Eigen::Matrix3d>> bounds = boundsOf(floor);
    std::vector<double> errors;
    const Pose frame = floor.stops.front().truth;
    for (const MapPlane& plane : map.planes) {
        if (plane.sightings.empty())
            continue;
        const Sighting& first = plane.sightings.front();
        const auto number = static_cast<std::size_t>(floor.stops[first.stop].planes[first.plane]);
        if (!bounds[number])
            continue;
        const OrientedPlane found = inFloor(plane.parameters.normal, plane.parameters.distance, frame);
        const OrientedPlane& truth = floor.planes[number];
        Eigen::Vector3d error;
        error.head<2>() = floor.tangents[number].transpose() * (found.normal - truth.normal);
        error.z() = found.distance - truth.distance;
        errors.push_back(error.dot(bounds[number]->ldlt().solve(error)));
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
