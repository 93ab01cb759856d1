// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include <Eigen/Core>

namespace planewright {

/// Normals of points, turned towards the sensor, and how far their neighbourhoods are from flat.
struct PointNormals {
    std::vector<Eigen::Vector3d> normals;
    std::vector<double> curvature;  ///< smallest eigenvalue of the neighbourhood's scatter as a share of all three
};

/// Normals by PCL's NormalEstimation from the k nearest neighbours. Points whose neighbours determine none have a
/// normal of length 0.
PointNormals normalsOf(const std::vector<Eigen::Vector3d>& points, int k);

}  // namespace planewright
