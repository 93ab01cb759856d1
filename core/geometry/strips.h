// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/geometry/plane_frame.h"

namespace planewright {

/// A line segment in the coordinates of its plane [m].
struct Stretch {
    Eigen::Vector2d start;
    Eigen::Vector2d end;
};

/// The stretches of one slice on a plane: pieces of one line.
struct Row {
    int number = 0;  ///< rises from row to row; neighbouring slices differ by 1
    std::vector<Stretch> stretches;
};

/// The strips between neighbouring stretches of different rows, as rings that wind counter-clockwise around them: a
/// ring holds a strip or a run of strips that share whole stretches, and may overlap itself.
///
/// A strip spans the overlap of its two stretches along their direction. Ends that differ by little more than the rows
/// are apart are joined by a slanted side; so are ends that differ by more where the border goes on in that direction
/// (a floor line across the fan of a side wall). All other ends are cut square, which keeps corners and openings.
/// A part of a stretch that meets nothing in the next row waits for a later one: up to three rows away, or as long as
/// the distance is below that at which a segment would be too short to be one.
///
/// Rows come in rising number. The cost is linear in the stretches.
std::vector<PlanarRing> stripsBetween(const std::vector<Row>& rows);

}  // namespace planewright
