// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include <Eigen/Core>

#include "tests/benchmarks/opponents/point_scan.h"

namespace planewright {

/// Normals of a scan's points by total least squares over a window of the grid, turned towards the sensor. Points of
/// the window beyond a jump of range take no part; with fewer than half of its points there is none (length 0).
std::vector<Eigen::Vector3d> gridNormals(const PointScan& scan, int windowSlices, int windowBeams);

}  // namespace planewright
