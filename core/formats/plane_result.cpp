// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/formats/plane_result.h"

#include <limits>

namespace planewright {

std::vector<PlaneResult> planeResults(const Snapshot& snapshot)
{
    std::vector<PlaneResult> results;
    results.reserve(snapshot.planes.size());
    for (const auto& plane : snapshot.planes)
        results.push_back({plane, outlineOf(*plane, snapshot.segments), {}, {}});
    return results;
}

std::vector<PlaneResult> planeResults(std::span<const EditedPlane> planes, const SegmentLog& log)
{
    std::vector<PlaneResult> results;
    results.reserve(planes.size());
    for (const EditedPlane& edited : planes)
        results.push_back({edited.plane, outlineOf(*edited.plane, log), edited.name, edited.className});
    return results;
}

PlaneResult knownPlane(PlaneId id, std::string_view name, const Eigen::Vector3d& normal, double distance, int points)
{
    auto plane = std::make_shared<Plane>();
    plane->id = id;
    plane->normal = normal;
    plane->distance = distance;
    makeCanonical(plane->normal, plane->distance);
    plane->points = points;
    plane->fittingError = std::numeric_limits<double>::quiet_NaN();
    plane->rms = std::numeric_limits<double>::quiet_NaN();
    return {std::move(plane), {}, std::string{name}, {}};
}

}  // namespace planewright
