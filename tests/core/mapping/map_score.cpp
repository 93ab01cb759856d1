// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tests/core/mapping/map_score.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include "core/mapping/extent.h"
#include "core/mapping/near_planes.h"
#include "core/types/angle.h"
#include "core/types/square.h"

namespace planewright {

namespace {

/// True where two sightings of one true plane overlap, each in its true place.
bool overlapInTruth(const SimulatedStop& a, std::size_t i, const StopExtents& extentsA, const SimulatedStop& b,
                    std::size_t j, const StopExtents& extentsB, const OrientedPlane& plane)
{
    const PlaneFrame frame(plane.normal, plane.distance, Eigen::Vector3d::UnitZ());
    return meet(onPlane(extentsA[i], a.truth, frame), onPlane(extentsB[j], b.truth, frame), 0.0);
}

/// The error along the directions that are known to this standard deviation.
double errorWhereKnown(const Eigen::Vector3d& error, const Eigen::Matrix3d& covariance, double known)
{
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solved{covariance};
    double sum = 0.0;
    for (int i = 0; i < 3; ++i) {
        if (std::sqrt(solved.eigenvalues()[i]) < known)
            sum += square(solved.eigenvectors().col(i).dot(error));
    }
    return std::sqrt(sum);
}

}  // namespace

MapScore scoreMap(const BuildingMap& map, std::span<const SimulatedStop> stops, std::span<const OrientedPlane> planes)
{
    MapScore score;
    const Pose toMap = stops.front().truth.inverse();
    std::vector<StopExtents> extents;
    for (std::size_t n = 0; n < stops.size(); ++n)
        extents.push_back(extentsOf(stops[n].stop));

    for (std::size_t n = 1; n < stops.size(); ++n) {
        const MapStop& stop = map.stops[n];
        if (!stop.isPlaced())
            continue;
        const Vector6d error = errorBetween(toMap * stops[n].truth, stop.pose);
        score.shifts.push_back(errorWhereKnown(error.tail<3>(), stop.covariance.bottomRightCorner<3, 3>(), 0.01));
        score.turns.push_back(errorWhereKnown(error.head<3>(), stop.covariance.topLeftCorner<3, 3>(), degrees(0.1)));
        score.poseErrors.push_back(error.dot(stop.covariance.ldlt().solve(error)));
        for (std::size_t i = 0; i < stop.matches.size(); ++i) {
            score.open += stop.matches[i].plane ? 0 : 1;
            bool isPossible = false;
            bool isMade = false;
            for (std::size_t m = 0; m < n; ++m) {
                for (std::size_t j = 0; j < stops[m].planes.size(); ++j) {
                    if (stops[m].planes[j] != stops[n].planes[i] || !map.stops[m].isPlaced())
                        continue;
                    const bool overlaps = overlapInTruth(stops[n], i, extents[n], stops[m], j, extents[m],
                                                         planes[static_cast<std::size_t>(stops[n].planes[i])]);
                    isPossible = isPossible || overlaps;
                    isMade = isMade || (overlaps && stop.matches[i].plane &&
                                        map.stops[m].matches[j].plane == stop.matches[i].plane);
                }
            }
            score.possible += isPossible ? 1 : 0;
            score.made += isMade ? 1 : 0;
        }
    }
    for (const MapPlane& plane : map.planes) {
        if (plane.sightings.empty())
            continue;
        const auto trueOf = [&](const Sighting& sighting) { return stops[sighting.stop].planes[sighting.plane]; };
        const int first = trueOf(plane.sightings.front());
        const auto wrong =
            std::ranges::count_if(plane.sightings, [&](const Sighting& sighting) { return trueOf(sighting) != first; });
        score.wrong += static_cast<int>(wrong);
        if (wrong > 0)
            continue;
        const OrientedPlane& known = planes[static_cast<std::size_t>(first)];
        UncertainPlane truth;
        truth.normal = known.normal;
        truth.distance = known.distance;
        truth = inMap(truth, toMap);
        // Where it was seen: errors of badly known angles are not small at a distance from there.
        const MapStop& stop = map.stops[plane.sightings.front().stop];
        const Eigen::Vector3d middle = stop.pose * middleOf(stop.stop->planes[plane.sightings.front().plane]);
        const UncertainPlane found = seenFrom(plane.parameters, middle);
        const Eigen::Vector3d error = difference(found, seenFrom(truth, middle));
        score.planeErrors.push_back(error.dot(found.covariance.ldlt().solve(error)));
    }
    return score;
}

double meanOf(std::span<const double> values)
{
    return values.empty() ? 0.0
                          : std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

}  // namespace planewright
