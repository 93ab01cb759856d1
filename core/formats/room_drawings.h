// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/formats/plane_result.h"

namespace planewright {

/// A drawing of a room as SVG, with what it is called.
struct RoomDrawing {
    std::string title;
    std::string svg;
};

/// The horizontal direction that a room's drawings are squared to: of the normals of upright planes that of the one
/// with the largest area, turned by quarter turns until it is nearest to y. y itself where there are none.
Eigen::Vector2d squaredDirection(std::span<const PlaneResult> planes);

/// Draws a room from above and, as seen from the scanner, to its front, right, back and left; squared to its walls.
///
/// The plan has the outlines of level planes, and thick where upright ones are cut at a height [m]. An elevation has
/// the planes that lie on its side and face the scanner within 60°, the farthest first, and thin those that it sees
/// edge-on. Each is as wide as fits `width` pixels; a side without planes is left out.
///
/// CSS classes: `floor`, `ceiling`, `wall` or `other` with `area`, `edge` or `cut`; `grid`, `bar`, `bar-text`,
/// `scanner`, `label`.
std::vector<RoomDrawing> roomDrawings(std::span<const PlaneResult> planes, double cutHeight, double width);

}  // namespace planewright
