// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "core/planes/plane_map.h"

namespace planewright {

/// Moves segments that lie nearer to another plane than to their own, now that all planes are known (part of the last
/// pass): the first segments on a wall may lie within D_m of the floor, and join it while the wall is no plane yet.
///
/// The rule is Eq. (8)'s: the plane with the smallest D_ij of those that pass. Planes that keep fewer segments than
/// `planes.min-segments` are dissolved into the clusters. All planes are refined afterwards.
void reassignSegments(PlaneMap& map, const Parameters& parameters, StepRecorder& recorder);

}  // namespace planewright
