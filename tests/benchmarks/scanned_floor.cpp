// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tests/benchmarks/scanned_floor.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include "core/formats/labels.h"
#include "core/geometry/tangents.h"
#include "core/mapping/near_planes.h"
#include "core/params/mapping_parameters.h"
#include "core/params/presets.h"
#include "core/pipeline/plane_extractor.h"
#include "core/simulation/nodding_scanner.h"
#include "tests/benchmarks/scoring.h"

namespace planewright {

namespace {

/// Found planes that are more than half a right angle off a true one are not of it.
constexpr double kLikeCosine = 0.7;

/// The true plane that most returns of each found plane lie on, of those that it may be; kNoTruePlane where none has
/// half of these. A line on the floor where a wall meets it lies in the wall's plane as well, and may be longer than
/// all that was seen of the wall.
std::map<PlaneId, int> truthOf(const Snapshot& found, const Scene& scene, const SimulatedScan& scan)
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
    for (const auto& plane : found.planes) {
        int points = 0;
        std::pair<int, int> most{0, kNoTruePlane};
        for (const auto& [number, hit] : counts[plane->id]) {
            const bool isPlane = number >= 0;
            if (isPlane &&
                std::abs(scene.planes[static_cast<std::size_t>(number)].normal.dot(plane->normal)) < kLikeCosine)
                continue;
            points += hit;
            most = std::max(most, {hit, isPlane ? number : kNoTruePlane});
        }
        truth[plane->id] = 2 * most.first > points ? most.second : kNoTruePlane;
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

/// Adds stop after stop to a floor.
class FloorScanner {
public:
    FloorScanner(const SimulatedBuilding& building, const BuildingStop& first, std::uint64_t seed)
        : building_(building), first_(first), seed_(seed), reference_(building.sceneAt(0, first.pose))
    {
        apply(*findPreset(methodPresets(), "precise"), parameters_);
        parameters_ = forMap(parameters_, {});
    }

    void scan(const BuildingStop& at, const std::optional<Motion>& odometry)
    {
        const Scene scene = building_.sceneAt(0, at.pose);
        const std::size_t n = floor_.stops.size();
        const SimulatedScan scan =
            simulate(scene, settings_, noise_, seed_ + 0x9e3779b97f4a7c15U * static_cast<std::uint64_t>(n + 1));
        PlaneExtractor extractor(sensorOf(scan.recording.description), parameters_);
        for (const ScanSlice& slice : scan.recording.slices)
            extractor.advance(slice);
        const std::vector<Side> sides = addSides(scene, scan, at.pose);
        addStop(*extractor.finish(), scene, scan, sides, at.pose, odometry);
    }

    ScannedFloor take() { return std::move(floor_); }

private:
    /// The side of each true plane that a stop sees, with what its points tell.
    std::vector<Side> addSides(const Scene& scene, const SimulatedScan& scan, const Pose& pose)
    {
        const std::vector<Eigen::Matrix3d> information = trueInformation(scene, scan, noise_);
        std::vector<Side> sides;
        auto& seen = floor_.seen.emplace_back();
        for (const TruePlane& plane : scene.planes) {
            const OrientedPlane there = inFloor(plane.normal, plane.distance, pose);
            const TruePlane& first = reference_.planes[static_cast<std::size_t>(plane.id)];
            const Side side{plane.id, there.normal.dot(first_.pose.rotation * first.normal) < 0.0};
            sides.push_back(side);
            const auto number = static_cast<std::size_t>(numberOf(side, there));
            const Eigen::Matrix3d& told = information[static_cast<std::size_t>(plane.id)];
            if (told(2, 2) > 0.0)
                seen[side] = {static_cast<int>(number), inFloor(told, plane, pose, floor_.tangents[number])};
        }
        return sides;
    }

    /// Doors of one wall, say, lie in one plane: it has one number.
    int numberOf(const Side& side, const OrientedPlane& plane)
    {
        const auto same =
            std::ranges::find_if(floor_.planes, [&](const OrientedPlane& other) { return isSamePlane(other, plane); });
        const auto [place, isNew] = numbers_.try_emplace(side, static_cast<int>(same - floor_.planes.begin()));
        if (isNew && same == floor_.planes.end())
            addPlane(plane);
        return place->second;
    }

    int addPlane(const OrientedPlane& plane)
    {
        floor_.planes.push_back(plane);
        floor_.tangents.push_back(tangentsOf(plane.normal));
        return static_cast<int>(floor_.planes.size()) - 1;
    }

    void addStop(const Snapshot& found, const Scene& scene, const SimulatedScan& scan, const std::vector<Side>& sides,
                 const Pose& pose, const std::optional<Motion>& odometry)
    {
        SimulatedStop stop;
        stop.truth = pose;
        stop.stop.id = static_cast<int>(floor_.stops.size());
        stop.stop.odometry = odometry;
        const std::map<PlaneId, int> truth = truthOf(found, scene, scan);
        auto& foundSides = floor_.sides.emplace_back();
        for (const auto& plane : found.planes) {
            stop.stop.planes.push_back(observedPlane(*plane, outlineOf(*plane, found.segments)));
            const auto known = truth.find(plane->id);
            if (known != truth.end() && known->second != kNoTruePlane) {
                const Side& side = sides[static_cast<std::size_t>(known->second)];
                foundSides.emplace_back(side);
                stop.planes.push_back(numbers_.at(side));
                continue;
            }
            // What is no true plane is nobody's partner.
            foundSides.emplace_back();
            stop.planes.push_back(addPlane(inFloor(plane->normal, plane->distance, pose)));
        }
        floor_.stops.push_back(std::move(stop));
    }

    const SimulatedBuilding& building_;
    const BuildingStop& first_;
    std::uint64_t seed_;
    Scene reference_;
    SimulationNoise noise_ = *simulationNoise("default");
    AcquisitionSettings settings_ = *acquisitionSettings("table8");
    Parameters parameters_;
    std::map<Side, int> numbers_;
    ScannedFloor floor_;
};

/// Which of some things are one: the smallest number of each set.
class Sets {
public:
    explicit Sets(std::size_t count) : parents_(count) { std::iota(parents_.begin(), parents_.end(), 0); }

    std::size_t of(std::size_t member) const
    {
        while (parents_[member] != member)
            member = parents_[member];
        return member;
    }
    void join(std::size_t a, std::size_t b)
    {
        const std::size_t first = of(a);
        const std::size_t second = of(b);
        parents_[std::max(first, second)] = std::min(first, second);
    }

private:
    std::vector<std::size_t> parents_;
};

/// The information of all that is unknown: 6 numbers of each stop but the first, 3 of each piece.
class FloorInformation {
public:
    FloorInformation(const ScannedFloor& floor, int pieces)
        : floor_(floor), all_(Eigen::MatrixXd::Zero(pieceColumn(pieces), pieceColumn(pieces)))
    {
    }

    void addSeen(std::size_t stop, int piece, const SideInformation& seen)
    {
        const Eigen::Matrix3d& information = seen.information;
        const Eigen::Index at = pieceColumn(piece);
        all_.block<3, 3>(at, at) += information;
        if (stop == 0)
            return;
        UncertainPlane there;
        const auto number = static_cast<std::size_t>(seen.plane);
        there.normal = floor_.planes[number].normal;
        there.distance = floor_.planes[number].distance;
        there.tangents = floor_.tangents[number];
        const Matrix3x6d byPose = -poseJacobian(there, floor_.stops[stop].truth);
        const Eigen::Index of = poseColumn(stop);
        all_.block<6, 6>(of, of) += byPose.transpose() * information * byPose;
        all_.block<3, 6>(at, of) += information * byPose;
        all_.block<6, 3>(of, at) += byPose.transpose() * information;
    }

    /// Of the motion from the stop before: what its error adds to the pose of the one, less what the other's does.
    void addMotion(std::size_t stop)
    {
        const Pose& before = floor_.stops[stop - 1].truth;
        const Matrix6d motion = turnedBy(before.rotation, floor_.stops[stop].stop.odometry->covariance);
        const Matrix6d known = motion.inverse();
        const Matrix6d carried = -carriedBy(floor_.stops[stop].truth.translation - before.translation);
        all_.block<6, 6>(poseColumn(stop), poseColumn(stop)) += known;
        if (stop == 1)
            return;
        all_.block<6, 6>(poseColumn(stop - 1), poseColumn(stop - 1)) += carried.transpose() * known * carried;
        all_.block<6, 6>(poseColumn(stop), poseColumn(stop - 1)) += known * carried;
        all_.block<6, 6>(poseColumn(stop - 1), poseColumn(stop)) += carried.transpose() * known;
    }

    std::vector<Eigen::Matrix3d> bounds(int pieces) const
    {
        const Eigen::MatrixXd covariance = all_.ldlt().solve(Eigen::MatrixXd::Identity(all_.rows(), all_.cols()));
        std::vector<Eigen::Matrix3d> bounds;
        for (int piece = 0; piece < pieces; ++piece)
            bounds.push_back(covariance.block<3, 3>(pieceColumn(piece), pieceColumn(piece)));
        return bounds;
    }

private:
    static Eigen::Index poseColumn(std::size_t stop) { return 6 * static_cast<Eigen::Index>(stop - 1); }
    Eigen::Index pieceColumn(int piece) const
    {
        return 6 * static_cast<Eigen::Index>(floor_.stops.size() - 1) + 3 * static_cast<Eigen::Index>(piece);
    }

    const ScannedFloor& floor_;
    Eigen::MatrixXd all_;
};

}  // namespace

ScannedFloor scanFloor(const SimulatedBuilding& building, const std::vector<BuildingStop>& route, std::uint64_t seed)
{
    FloorScanner scanner(building, route.front(), seed);
    for (std::size_t n = 0; n < route.size(); ++n) {
        std::optional<Motion> odometry;
        if (n > 0) {
            const Pose motion = route[n - 1].odometry.inverse() * route[n].odometry;
            odometry = Motion{motion, odometryCovariance(motion, {})};
        }
        scanner.scan(route[n], odometry);
    }
    return scanner.take();
}

std::vector<std::vector<int>> piecesOf(const ScannedFloor& floor)
{
    struct Found {
        std::size_t stop;
        std::size_t plane;
        std::vector<PlanarRing> rings;
    };
    std::map<int, std::vector<std::size_t>> ofPlane;  // by number of the true plane
    std::vector<Found> all;
    for (std::size_t stop = 0; stop < floor.stops.size(); ++stop) {
        const StopExtents extents = extentsOf(floor.stops[stop].stop);
        for (std::size_t i = 0; i < extents.size(); ++i) {
            const int number = floor.stops[stop].planes[i];
            const OrientedPlane& plane = floor.planes[static_cast<std::size_t>(number)];
            const PlaneFrame frame(plane.normal, plane.distance, Eigen::Vector3d::UnitZ());
            ofPlane[number].push_back(all.size());
            all.push_back({stop, i, onPlane(extents[i], floor.stops[stop].truth, frame)});
        }
    }
    Sets sets(all.size());
    const auto areOne = [&](const Found& a, const Found& b) {
        const bool isOneSide = a.stop == b.stop && floor.sides[a.stop][a.plane] == floor.sides[b.stop][b.plane];
        return isOneSide || meet(a.rings, b.rings, 0.0);
    };
    for (const auto& [number, found] : ofPlane) {
        for (std::size_t i = 0; i < found.size(); ++i) {
            for (std::size_t j = 0; j < i; ++j) {
                if (sets.of(found[i]) != sets.of(found[j]) && areOne(all[found[i]], all[found[j]]))
                    sets.join(found[i], found[j]);
            }
        }
    }
    std::map<std::size_t, int> numbers;
    std::vector<std::vector<int>> pieces(floor.stops.size());
    for (std::size_t i = 0; i < all.size(); ++i)
        pieces[all[i].stop].push_back(numbers.try_emplace(sets.of(i), static_cast<int>(numbers.size())).first->second);
    return pieces;
}

std::vector<Eigen::Matrix3d> boundsOf(const ScannedFloor& floor, const std::vector<std::vector<int>>& pieces)
{
    int count = 0;
    std::map<Side, int> firstOf;
    std::vector<std::map<Side, int>> ofStop(pieces.size());
    for (std::size_t stop = 0; stop < pieces.size(); ++stop) {
        for (std::size_t i = 0; i < pieces[stop].size(); ++i) {
            count = std::max(count, pieces[stop][i] + 1);
            if (!floor.sides[stop][i])
                continue;
            firstOf.try_emplace(*floor.sides[stop][i], pieces[stop][i]);
            ofStop[stop].try_emplace(*floor.sides[stop][i], pieces[stop][i]);
        }
    }
    FloorInformation information(floor, count);
    for (std::size_t stop = 0; stop < floor.stops.size(); ++stop) {
        for (const auto& [side, seen] : floor.seen[stop]) {
            const auto own = ofStop[stop].find(side);
            const auto first = firstOf.find(side);
            if (first != firstOf.end())
                information.addSeen(stop, own != ofStop[stop].end() ? own->second : first->second, seen);
        }
        if (stop > 0)
            information.addMotion(stop);
    }
    return information.bounds(count);
}

}  // namespace planewright
