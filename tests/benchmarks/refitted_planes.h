// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include "core/params/parameters.h"
#include "tests/benchmarks/repeated_planes.h"

namespace planewright {

/// Each plane of a whole recording fitted twice, to its segments of the even slices and to those of the odd ones.
///
/// Which segments belong to a plane is what the whole recording says, for both alike: what is left between the two is
/// noise, and nothing of it a different decision. Left out are planes with fewer points and those that either half
/// does not determine; `first` and `second` are the fits, with the id of the plane.
std::vector<RepeatedPlane> refittedPlanes(const Extracted& whole, const Parameters& parameters, int minPoints);

}  // namespace planewright
