// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include "core/geometry/plane_frame.h"

namespace planewright {

/// A connected area: outer ring counter-clockwise, holes clockwise.
struct PlanarPolygon {
    PlanarRing ring;
    std::vector<PlanarRing> holes;
};

/// The union of rings: the points that they wind around in sum, as counter-clockwise rings do around their inside. It
/// is computed on a grid of a micrometre (coarser beyond 500 m) and keeps corners to a millimetre.
///
/// Cracks up to 4 cm wide and holes below 1 dm² are closed, parts below 10 cm² are left out: they come from the noise
/// of segment ends. No order of parts, holes and first vertices is promised.
std::vector<PlanarPolygon> unionOf(const std::vector<PlanarRing>& rings);

/// The area [m²] that two sets of rings share, each being what its rings wind around, clockwise ones taken off; on the
/// same grid.
double sharedArea(const std::vector<PlanarRing>& a, const std::vector<PlanarRing>& b);

/// Signed area of a ring [m²], positive if counter-clockwise.
double signedArea(const PlanarRing& ring);

}  // namespace planewright
