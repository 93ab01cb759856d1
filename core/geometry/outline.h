// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/types/plane.h"
#include "core/types/segment_log.h"

namespace planewright {

/// The polygons in which a plane was seen, with what is measured on them. Frame and units as LineSegment.
///
/// All vertices lie on the plane. Rings are not closed (the first vertex is not repeated), counter-clockwise seen from
/// +n; holes are clockwise. A ring starts at its smallest vertex by (x, y, z); holes and parts are ordered by their
/// vertices in the same way.
struct Outline {
    /// One connected part.
    struct Polygon {
        std::vector<Eigen::Vector3d> ring;                ///< [m]
        std::vector<std::vector<Eigen::Vector3d>> holes;  ///< [m]
    };

    std::vector<Polygon> parts;
    double area = 0.0;                                   ///< of all parts, holes taken off [m²]
    double width = 0.0;                                  ///< side of the least rectangle, see outlineOf [m]
    double height = 0.0;                                 ///< its other side [m]
    Eigen::Vector3d centroid = Eigen::Vector3d::Zero();  ///< of the area, on the plane [m]
};

/// The union of the strips between a plane's neighbouring segments: an L-shaped wall keeps its corner, a wall its door.
///
/// Neighbours overlap along their direction and are seen in slices that follow each other for this plane: a part missed
/// in a slice or two is bridged. Where no two segments overlap, the convex hull of all end points stands in; end points
/// on one line have no parts and no area.
///
/// Width and height are the sides of the rectangle of least area in the plane around all parts. Width is the more
/// horizontal one; where both are level within 10° (floor, ceiling, table), it is the longer one.
///
/// `log` is the one that the plane's segments belong to. A plane without segments gives an empty outline.
Outline outlineOf(const Plane& plane, const SegmentLog& log);

/// The outline of parts that lie on the plane n·p = d, measured in the same way.
Outline outlineOf(const std::vector<Outline::Polygon>& parts, const Eigen::Vector3d& normal, double distance);

}  // namespace planewright
