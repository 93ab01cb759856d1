// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/mapping/building_map.h"
#include "core/mapping/extent.h"
#include "core/mapping/place_by_planes.h"
#include "core/mapping/stop_tree.h"

namespace planewright {

/// The extents of all planes of a stop, in its frame.
using StopExtents = std::vector<Extent>;
StopExtents extentsOf(const Stop& stop);

/// A plane of the map as some stops near by know it.
struct NearPlane {
    std::size_t plane = 0;          ///< in BuildingMap::planes
    UncertainPlane parameters;      ///< in the map's frame; the covariance bounds the error against the anchor stop
    double area = 0.0;              ///< largest that one of the stops saw [m²]
    std::vector<PlanarRing> rings;  ///< where these stops saw it, in `frame`
    PlaneFrame frame;
};

/// The planes that some stops saw, by their number in the map. Errors are against one of the stops, the anchor: those
/// of the best observation of each plane, and the drift between its stop and the anchor.
class NearPlanes {
public:
    NearPlanes(const BuildingMap& map, std::span<const StopExtents> extents, std::span<const std::size_t> stops,
               const StopTree& tree, std::size_t anchor);

    std::span<const NearPlane> planes() const { return planes_; }

    /// True where a stop's plane at a pose and the near plane of this place overlap or are at most `gap` [m] apart.
    bool meets(const Extent& seen, const Pose& pose, std::size_t near, double gap) const;

    /// Of the places where a stop's plane at a pose and the near plane of this place were seen, how much of the smaller
    /// one lies in the other, 0 to about 1.
    double coverage(const Extent& seen, const Pose& pose, std::size_t near) const;

    /// True where two near planes were seen in places that overlap, each laid on the first.
    bool overlap(std::size_t a, std::size_t b) const;

    /// For a search of the place.
    std::vector<WeighedPlane> weighed() const;

private:
    std::vector<NearPlane> planes_;
};

/// Planes near by, by their number in the map, through which a stop at a pose would see something farther: where the
/// line of sight to the middle of a part of its planes crosses another's outline well before it ends, from the seen
/// side.
std::vector<std::size_t> planesSeenThrough(const Pose& pose, const StopExtents& extents, const NearPlanes& near);

/// Area of an extent [m²].
double areaOf(const Extent& extent);

}  // namespace planewright
