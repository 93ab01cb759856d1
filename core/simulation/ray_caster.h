// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "core/simulation/scene.h"

namespace planewright {

/// What a ray hits first.
struct RayHit {
    double range = 0.0;       ///< from the laser [m]
    int label = kNotPlanar;   ///< id of the TruePlane, or kNotPlanar
    std::size_t surface = 0;  ///< rectangles first, then cylinders: tells one cylinder from another
    double dropout = 0.0;     ///< share of returns lost on this surface
};

/// Indices of the surfaces that a slice may meet.
struct SurfaceSelection {
    std::vector<std::size_t> rectangles;
    std::vector<std::size_t> cylinders;
};

/// Every surface of a scene.
SurfaceSelection allSurfaces(const Scene& scene);

/// The surfaces that rays may meet which leave the laser at a tilt [rad], or up to `spread` [rad] off that tilt's slice
/// plane; others may be among them, none is missing.
SurfaceSelection surfacesNear(const Scene& scene, double tilt, double pitchAxisOffset, double spread);

/// Casts the rays of one slice.
///
/// Works in the slice's frame: origin at the laser, first axis e_x, second where bearing 90° looks, third the normal of
/// the slice plane, so that a beam at bearing θ is (cos θ, sin θ, 0), Eq. (6).
class RayCaster {
public:
    RayCaster(const Scene& scene, const SurfaceSelection& selection, double tilt, double pitchAxisOffset);

    /// The nearest surface along a unit direction in the slice's frame; empty where there is none.
    std::optional<RayHit> cast(const Eigen::Vector3d& direction) const;

private:
    struct Rectangle {
        Eigen::Vector3d normal;  ///< not of unit length
        double distance;         ///< of the laser from the plane, in units of the normal's length
        Eigen::Vector3d toU;     ///< p·toU − originU = a of RectangleSurface
        double originU;
        Eigen::Vector3d toV;
        double originV;
        std::size_t index;
    };
    struct Cylinder {
        Eigen::Vector3d base;
        Eigen::Vector3d first;   ///< unit, to where the sector begins
        Eigen::Vector3d second;  ///< unit, a quarter turn further
        Eigen::Vector3d axis;    ///< unit
        double radius;
        double height;
        double sweep;
        std::size_t index;
    };

    void castAtCylinder(const Cylinder& cylinder, const Eigen::Vector3d& direction, RayHit& nearest) const;

    const Scene& scene_;
    std::vector<Rectangle> rectangles_;
    std::vector<Cylinder> cylinders_;
};

}  // namespace planewright
