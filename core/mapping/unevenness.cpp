// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/mapping/unevenness.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include <Eigen/Cholesky>

#include "core/types/square.h"

namespace planewright {

namespace {

constexpr double kMedianChi3 = 2.366;   // of χ² with 3 degrees of freedom
constexpr double kLeastShare = 0.005;   // of what was told
constexpr std::size_t kLeastSeen = 20;  // sightings that tell something
constexpr int kHalvings = 12;           // of the interval in which it is looked for

/// A sighting against the plane of the map, both seen from the middle of where it was seen.
struct Residual {
    Eigen::Vector3d apart;
    Eigen::Matrix3d covariance;  ///< without unevenness
    Eigen::Matrix3d uneven;      ///< what unevenness of 1 m adds
};

Eigen::Matrix3d unevenCovariance(const ObservedPlane& plane)
{
    ObservedPlane uneven = plane;
    uneven.parameters.covariance.setZero();
    addFlatness(uneven, 1.0);
    return uneven.parameters.covariance;
}

struct Residuals {
    std::vector<Residual> all;
    double freedom = 1.0;  ///< degrees of freedom over the numbers that they are
};

Residuals residualsOf(const BuildingMap& map, double inUse)
{
    Residuals residuals;
    double planes = 0.0;
    std::vector<bool> counts(map.stops.size(), false);
    for (const MapPlane& plane : map.planes) {
        if (plane.sightings.size() < 2)
            continue;
        planes += 1.0;
        for (const Sighting& sighting : plane.sightings) {
            const MapStop& stop = map.stops[sighting.stop];
            const ObservedPlane& seen = stop.stop->planes[sighting.plane];
            counts[sighting.stop] = true;
            const Eigen::Matrix3d uneven = unevenCovariance(seen);
            UncertainPlane even = seen.parameters;
            even.covariance -= square(inUse) * uneven;
            UncertainPlane rough = seen.parameters;
            rough.covariance = uneven;
            const Eigen::Vector3d middle = stop.pose * middleOf(seen);
            const UncertainPlane there = seenFrom(inMap(even, stop.pose), middle);
            residuals.all.push_back({difference(there, seenFrom(plane.parameters, middle)), there.covariance,
                                     seenFrom(inMap(rough, stop.pose), middle).covariance});
        }
    }
    // Of three numbers a sighting, three a plane and six a pose are fitted.
    const auto stops = static_cast<double>(std::ranges::count(counts, true));
    const auto seen = static_cast<double>(residuals.all.size());
    if (seen > 0.0)
        residuals.freedom = std::max(0.1, (seen - planes - 2.0 * std::max(0.0, stops - 1.0)) / seen);
    return residuals;
}

double medianChi(const std::vector<Residual>& residuals, double flatness)
{
    std::vector<double> chis;
    chis.reserve(residuals.size());
    for (const Residual& residual : residuals) {
        const Eigen::Matrix3d covariance = residual.covariance + square(flatness) * residual.uneven;
        chis.push_back(residual.apart.dot(covariance.ldlt().solve(residual.apart)));
    }
    const auto middle = chis.begin() + static_cast<std::ptrdiff_t>(chis.size() / 2);
    std::ranges::nth_element(chis, middle);
    return *middle;
}

}  // namespace

double unevennessOf(const BuildingMap& map, double inUse, double told)
{
    const auto [residuals, freedom] = residualsOf(map, inUse);
    if (residuals.size() < kLeastSeen)
        return inUse;
    const double expected = freedom * kMedianChi3;
    double low = kLeastShare * told;
    double high = told;
    if (medianChi(residuals, low) <= expected)
        return low;
    if (medianChi(residuals, high) >= expected)
        return high;
    for (int i = 0; i < kHalvings; ++i) {
        const double between = std::sqrt(low * high);
        (medianChi(residuals, between) > expected ? low : high) = between;
    }
    return high;
}

void changeFlatness(BuildingMap& map, double from, double to)
{
    for (MapStop& stop : map.stops) {
        auto changed = std::make_shared<Stop>(*stop.stop);
        for (ObservedPlane& plane : changed->planes)
            plane.parameters.covariance += (square(to) - square(from)) * unevenCovariance(plane);
        stop.stop = std::move(changed);
    }
}

}  // namespace planewright
