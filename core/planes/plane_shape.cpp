// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/planes/plane_shape.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Eigenvalues>

namespace planewright {

double shorterExtent(const std::vector<SegmentNumber>& members, const PlaneFit& fit, const SegmentTable& table)
{
    Eigen::Vector2d mean = Eigen::Vector2d::Zero();
    Eigen::Matrix2d second = Eigen::Matrix2d::Zero();
    std::vector<Eigen::Vector2d> flat;
    for (const SegmentNumber number : members) {
        for (const Eigen::Vector3d& point : {table[number].start, table[number].end}) {
            flat.emplace_back(fit.tangents.transpose() * point);
            mean += flat.back();
        }
    }
    mean /= static_cast<double>(flat.size());
    for (const Eigen::Vector2d& point : flat)
        second += (point - mean) * (point - mean).transpose();
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> eigen;
    eigen.computeDirect(second);
    const Eigen::Vector2d axis = eigen.eigenvectors().col(0);
    double lowest = std::numeric_limits<double>::infinity();
    double highest = -lowest;
    for (const Eigen::Vector2d& point : flat) {
        lowest = std::min(lowest, axis.dot(point));
        highest = std::max(highest, axis.dot(point));
    }
    return highest - lowest;
}

PlaneView viewOf(const std::vector<SegmentNumber>& members, const PlaneFit& fit, const SegmentTable& table)
{
    PlaneView view;
    for (const SegmentNumber number : members) {
        const LineSegment& segment = table[number];
        const Eigen::Vector3d ray = segment.midpoint() - segment.viewpoint;
        view.range += ray.norm();
        view.incidence += std::abs(fit.normal.dot(ray)) / ray.norm();
    }
    view.range /= static_cast<double>(members.size());
    view.incidence /= static_cast<double>(members.size());
    return view;
}

}  // namespace planewright
