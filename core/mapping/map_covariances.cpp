// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/mapping/map_covariances.h"

#include <cmath>
#include <vector>

#include <Eigen/Cholesky>

#include "core/mapping/sparse_inverse.h"

namespace planewright {

namespace {

/// Places of the unknowns: 6 a stop but the first, 3 a plane; negative for none.
struct Unknowns {
    std::vector<int> stops;
    std::vector<int> planes;
    int count = 0;

    explicit Unknowns(const BuildingMap& map)
    {
        for (const MapStop& stop : map.stops) {
            const bool isFree = stop.isPlaced() && stop.trust != StopTrust::First;
            stops.push_back(isFree ? count : -1);
            count += isFree ? 6 : 0;
        }
        for (const MapPlane& plane : map.planes) {
            planes.push_back(plane.sightings.empty() ? -1 : count);
            count += plane.sightings.empty() ? 0 : 3;
        }
    }
};

/// The information of all factors, its lower half.
class MapInformation {
public:
    explicit MapInformation(int count) : count_(count) {}

    /// Adds J'C⁻¹J of a factor on two unknowns, weighted as Huber's loss does at this residual.
    template <int N, int A, int B>
    void add(int first, const Eigen::Matrix<double, N, A>& byFirst, int second,
             const Eigen::Matrix<double, N, B>& bySecond, const Eigen::Matrix<double, N, N>& covariance,
             const Eigen::Matrix<double, N, 1>& residual)
    {
        const Eigen::LLT<Eigen::Matrix<double, N, N>> llt(covariance);
        const double chi = std::sqrt(residual.dot(llt.solve(residual)));
        const double limit = std::sqrt(chiSquareLimit(N));
        const double weight = chi > limit ? limit / chi : 1.0;
        const Eigen::Matrix<double, N, A> a = weight * llt.solve(byFirst);
        const Eigen::Matrix<double, N, B> b = weight * llt.solve(bySecond);
        put(first, first, byFirst.transpose() * a);
        put(second, second, bySecond.transpose() * b);
        if (first < second)
            put(second, first, bySecond.transpose() * a);
        else
            put(first, second, byFirst.transpose() * b);
    }

    Eigen::SparseMatrix<double> matrix() const
    {
        Eigen::SparseMatrix<double> information(count_, count_);
        information.setFromTriplets(entries_.begin(), entries_.end());
        return information;
    }

private:
    template <class Block>
    void put(int row, int column, const Block& block)
    {
        if (row < 0 || column < 0)
            return;
        for (int r = 0; r < block.rows(); ++r) {
            for (int c = 0; c < block.cols(); ++c) {
                if (row + r >= column + c)
                    entries_.emplace_back(row + r, column + c, block(r, c));
            }
        }
    }

    int count_;
    std::vector<Eigen::Triplet<double>> entries_;
};

void addSightings(const BuildingMap& map, std::size_t number, const Unknowns& unknowns, MapInformation& information)
{
    const MapPlane& plane = map.planes[number];
    for (const Sighting& sighting : plane.sightings) {
        const MapStop& stop = map.stops[sighting.stop];
        const ObservedPlane& told = stop.stop->planes[sighting.plane];
        const Eigen::Vector3d middle = stop.pose * middleOf(told);
        const Pose fromMiddle{stop.pose.rotation, stop.pose.translation - middle};
        const UncertainPlane seen = inMap(told.parameters, fromMiddle);
        const UncertainPlane known = seenFrom(plane.parameters, middle);
        // By both at the map's plane: stop and plane moved together tell nothing, however far the sighting is off it.
        Eigen::Matrix3d byPlane = Eigen::Matrix3d::Identity();
        byPlane.bottomLeftCorner<1, 2>() = -middle.transpose() * known.tangents;
        const Matrix3x6d byPose = -poseJacobian(known, fromMiddle);
        information.add<3, 6, 3>(unknowns.stops[sighting.stop], byPose, unknowns.planes[number], byPlane,
                                 covarianceIn(known, seen), difference(known, seen));
    }
}

void addMotion(const BuildingMap& map, std::size_t to, const Unknowns& unknowns, MapInformation& information)
{
    const auto& [from, told] = *map.stops[to].odometry;
    const Pose& before = map.stops[from].pose;
    const Pose& after = map.stops[to].pose;
    // Along the axes of the map, about the stop before.
    const Matrix6d covariance = turnedBy(before.rotation, told.covariance);
    const Pose expected = before * told.pose;
    const Matrix6d byAfter = Matrix6d::Identity();
    const Matrix6d byBefore = -carriedBy(after.translation - before.translation);
    information.add<6, 6, 6>(unknowns.stops[from], byBefore, unknowns.stops[to], byAfter, covariance,
                             errorBetween(expected, after));
}

template <int N>
Eigen::Matrix<double, N, N> blockOf(const SparseInverse& inverse, int at)
{
    Eigen::Matrix<double, N, N> block;
    for (int r = 0; r < N; ++r) {
        for (int c = 0; c < N; ++c)
            block(r, c) = inverse(at + r, at + c);
    }
    return block;
}

}  // namespace

Result<void> computeCovariances(BuildingMap& map)
{
    const Unknowns unknowns(map);
    if (unknowns.count == 0)
        return {};
    MapInformation information(unknowns.count);
    for (std::size_t plane = 0; plane < map.planes.size(); ++plane)
        addSightings(map, plane, unknowns, information);
    for (std::size_t stop = 0; stop < map.stops.size(); ++stop) {
        if (map.stops[stop].odometry)
            addMotion(map, stop, unknowns, information);
    }
    const SparseInverse inverse(information.matrix());
    if (!inverse.isThere())
        return fail(ErrorCode::Internal, "The map's observations do not fix all of its stops; add odometry.");
    for (std::size_t stop = 0; stop < map.stops.size(); ++stop) {
        if (unknowns.stops[stop] >= 0)
            map.stops[stop].covariance = blockOf<6>(inverse, unknowns.stops[stop]);
    }
    for (std::size_t plane = 0; plane < map.planes.size(); ++plane) {
        if (unknowns.planes[plane] >= 0)
            map.planes[plane].parameters.covariance = blockOf<3>(inverse, unknowns.planes[plane]);
    }
    return {};
}

}  // namespace planewright
