// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/geometry/cloud_scan.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

namespace planewright {

namespace {

constexpr double kLeapCosine = 0.70710678118654752;  // of 45°
/// A step back by less than this [rad] is how the numbers of a file are rounded.
constexpr double kRoundedStep = 1e-6;
/// Sweeps of fewer points do not tell which of two a point between them belongs to.
constexpr std::size_t kFewestOfSweep = 3;

Eigen::Vector3d rayOf(const CloudPoint& point)
{
    return point.place.cast<double>().normalized();
}

/// The turns from each ray to the next, summed: at a right angle to the sweep.
Eigen::Vector3d turnOf(std::span<const CloudPoint> sweep)
{
    Eigen::Vector3d turn = Eigen::Vector3d::Zero();
    for (std::size_t i = 1; i < sweep.size(); ++i)
        turn += rayOf(sweep[i - 1]).cross(rayOf(sweep[i]));
    return turn;
}

/// What neighbouring rays are mostly apart, as a sine.
double medianStep(std::span<const CloudPoint> sweep)
{
    std::vector<double> steps;
    for (std::size_t i = 1; i < sweep.size(); ++i)
        steps.push_back(rayOf(sweep[i - 1]).cross(rayOf(sweep[i])).norm());
    const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
    std::nth_element(steps.begin(), middle, steps.end());
    return *middle;
}

/// How far a ray is off the plane through the scanner that a sweep's rays lie in, as a sine.
double offPlaneOf(std::span<const CloudPoint> sweep, const Eigen::Vector3d& ray)
{
    Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
    for (const CloudPoint& point : sweep)
        squares.noalias() += rayOf(point) * rayOf(point).transpose();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(squares);
    return std::abs(axes.eigenvectors().col(0).dot(ray));
}

/// True where two sweeps go to and fro and the last point of the first is already one of the second: it does not go
/// on by a step, or lies rather in the plane of the second.
bool endsInNext(std::span<const CloudPoint> sweep, std::span<const CloudPoint> next)
{
    if (sweep.size() <= kFewestOfSweep || next.size() < kFewestOfSweep || turnOf(sweep).dot(turnOf(next)) >= 0.0)
        return false;
    const Eigen::Vector3d last = rayOf(sweep.back());
    const std::span<const CloudPoint> others = sweep.first(sweep.size() - 1);
    const Eigen::Vector3d normal = turnOf(others).normalized();
    if (rayOf(others.back()).cross(last).dot(normal) < 0.5 * medianStep(others))
        return true;
    return offPlaneOf(next, last) < 0.5 * offPlaneOf(others, last);
}

}  // namespace

std::vector<CloudSlice> splitSweeps(std::span<const Eigen::Vector3f> points)
{
    std::vector<CloudSlice> slices;
    Eigen::Vector3d before = Eigen::Vector3d::Zero();
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();  // Σ of the steps so far: at a right angle to the sweep
    for (const Eigen::Vector3f& point : points) {
        const Eigen::Vector3d ray = point.cast<double>().normalized();
        const Eigen::Vector3d turn = before.cross(ray);
        const bool isBack = !normal.isZero(0.0) && turn.dot(normal) < -kRoundedStep * normal.norm();
        if (slices.empty() || isBack || before.dot(ray) < kLeapCosine) {
            slices.emplace_back();
            normal.setZero();
        } else {
            normal += turn;
        }
        slices.back().push_back({point, 0});
        before = ray;
    }
    for (std::size_t i = 1; i < slices.size(); ++i) {
        if (!endsInNext(slices[i - 1], slices[i]))
            continue;
        slices[i].insert(slices[i].begin(), slices[i - 1].back());
        slices[i - 1].pop_back();
    }
    return slices;
}

}  // namespace planewright
