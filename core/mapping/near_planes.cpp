// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/mapping/near_planes.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace planewright {

namespace {

constexpr double kCornerTolerance = 0.03;  // [m]

/// How badly a plane is known some metres from where it stands: what observations of it are compared by [m²].
double badness(const Eigen::Matrix3d& covariance)
{
    constexpr double kLever = 5.0;  // [m]
    return covariance(2, 2) + kLever * kLever * (covariance(0, 0) + covariance(1, 1));
}

}  // namespace

StopExtents extentsOf(const Stop& stop)
{
    StopExtents extents;
    for (const ObservedPlane& plane : stop.planes)
        extents.push_back(extentOf(plane.parts, plane.parameters.normal, kCornerTolerance));
    return extents;
}

double areaOf(const Extent& extent)
{
    double area = 0.0;
    for (const auto& ring : extent) {
        Eigen::Vector3d doubled = Eigen::Vector3d::Zero();
        for (std::size_t i = 2; i < ring.size(); ++i)
            doubled += (ring[i - 1] - ring[0]).cross(ring[i] - ring[0]);
        area += 0.5 * doubled.norm();
    }
    return area;
}

NearPlanes::NearPlanes(const BuildingMap& map, std::span<const StopExtents> extents, std::span<const std::size_t> stops,
                       const StopTree& tree, std::size_t anchor)
{
    std::map<std::size_t, std::vector<Sighting>> sightings;
    for (const std::size_t stop : stops) {
        const auto& matches = map.stops[stop].matches;
        for (std::size_t i = 0; i < matches.size(); ++i) {
            if (matches[i].plane)
                sightings[*matches[i].plane].push_back({stop, i});
        }
    }
    const Eigen::Vector3d here = map.stops[anchor].pose.translation;
    std::map<std::size_t, Matrix6d> drifts;
    for (const std::size_t stop : stops)
        drifts[stop] = tree.between(anchor, stop, here);

    for (const auto& [number, seen] : sightings) {
        const UncertainPlane& known = map.planes[number].parameters;
        const UncertainPlane fromHere = seenFrom(known, here);
        const PlaneFrame frame(known.normal, known.distance, Eigen::Vector3d::UnitZ());
        NearPlane near{number, fromHere, 0.0, {}, frame};
        double best = INFINITY;
        for (const Sighting& sighting : seen) {
            const MapStop& stop = map.stops[sighting.stop];
            const UncertainPlane& own = stop.stop->planes[sighting.plane].parameters;
            const UncertainPlane there = seenFrom(inMap(own, stop.pose), here);
            const Matrix3x6d jacobian = poseJacobian(fromHere, {});
            const Eigen::Matrix3d covariance =
                covarianceIn(fromHere, there) + jacobian * drifts[sighting.stop] * jacobian.transpose();
            if (badness(covariance) < best) {
                best = badness(covariance);
                near.parameters.covariance = covariance;
            }
            const Extent& extent = extents[sighting.stop][sighting.plane];
            near.area = std::max(near.area, areaOf(extent));
            for (PlanarRing& ring : onPlane(extent, stop.pose, frame))
                near.rings.push_back(std::move(ring));
        }
        near.parameters = seenFrom(near.parameters, -here);
        planes_.push_back(std::move(near));
    }
}

bool NearPlanes::meets(const Extent& seen, const Pose& pose, std::size_t near, double gap) const
{
    const NearPlane& plane = planes_[near];
    return meet(onPlane(seen, pose, plane.frame), plane.rings, gap);
}

double NearPlanes::coverage(const Extent& seen, const Pose& pose, std::size_t near) const
{
    constexpr int kSamples = 12;  // along each side
    const NearPlane& plane = planes_[near];
    const std::vector<PlanarRing> rings = onPlane(seen, pose, plane.frame);
    Eigen::AlignedBox2d box;
    for (const PlanarRing& ring : rings) {
        for (const Eigen::Vector2d& corner : ring)
            box.extend(corner);
    }
    int inside = 0;
    int common = 0;
    for (int i = 0; i < kSamples * kSamples; ++i) {
        const Eigen::Array2d share{(i % kSamples + 0.5) / kSamples, (i / kSamples + 0.5) / kSamples};
        const Eigen::Vector2d point = box.min() + (share * box.sizes().array()).matrix();
        if (!contains(rings, point))
            continue;
        ++inside;
        common += contains(plane.rings, point) ? 1 : 0;
    }
    const double area = areaOf(seen);
    return inside == 0 ? 0.0 : area * common / inside / std::min(area, plane.area);
}

bool NearPlanes::overlap(std::size_t a, std::size_t b) const
{
    const NearPlane& first = planes_[a];
    const NearPlane& second = planes_[b];
    std::vector<PlanarRing> laid;
    for (const PlanarRing& ring : second.rings) {
        PlanarRing& there = laid.emplace_back();
        for (const Eigen::Vector2d& corner : ring)
            there.push_back(first.frame.toPlane(second.frame.toSpace(corner)));
    }
    return meet(first.rings, laid, 0.0);
}

std::vector<WeighedPlane> NearPlanes::weighed() const
{
    std::vector<WeighedPlane> planes;
    for (const NearPlane& plane : planes_)
        planes.push_back({plane.parameters, plane.area});
    return planes;
}

std::vector<std::size_t> planesSeenThrough(const Pose& pose, const StopExtents& extents, const NearPlanes& near)
{
    constexpr double kBehind = 0.3;  // farther than what outlines and unevenness explain [m]
    const Eigen::Vector3d& eye = pose.translation;
    std::vector<std::size_t> through;
    for (const NearPlane& plane : near.planes()) {
        const Eigen::Vector3d& normal = plane.parameters.normal;
        const double ahead = plane.parameters.distance - normal.dot(eye);
        if (ahead <= 0.0)
            continue;
        const bool isCrossed = std::ranges::any_of(extents, [&](const Extent& extent) {
            return std::ranges::any_of(extent, [&](const std::vector<Eigen::Vector3d>& ring) {
                Eigen::Vector3d middle = Eigen::Vector3d::Zero();
                for (const Eigen::Vector3d& corner : ring)
                    middle += corner / static_cast<double>(ring.size());
                const Eigen::Vector3d sight = pose * middle - eye;
                const double towards = normal.dot(sight);
                return towards > ahead + kBehind &&
                       contains(plane.rings, plane.frame.toPlane(eye + ahead / towards * sight));
            });
        });
        if (isCrossed)
            through.push_back(plane.plane);
    }
    return through;
}

}  // namespace planewright
