// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "core/geometry/plane_frame.h"

namespace planewright {

/// A ring with fewer vertices: those left out lie within the tolerance [m] of it (Douglas and Peucker 1973).
PlanarRing simplifyRing(const PlanarRing& ring, double tolerance);

}  // namespace planewright
