// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/geometry/pitch_axis.h"

#include <cmath>
#include <utility>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

namespace planewright {

namespace {

constexpr double kSnapped = 1e-5;      ///< [rad]
constexpr double kSmallest = 1e-12;    ///< of what directions scatter, in squares of sines
constexpr double kOnePlane = 1e-5;     ///< normals that turn by less (squared sine) are of one plane
constexpr double kClearlyAhead = 0.2;  ///< of how far points are ahead, the share by which one side must prevail
constexpr int kMostIterations = 30;

/// Sums over the unit directions r of a slice's points.
struct DirectionMoments {
    Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();  ///< Σ r rᵀ
    double count = 0.0;
};

std::vector<DirectionMoments> momentsOfSlices(const std::vector<CloudSlice>& slices)
{
    std::vector<DirectionMoments> all(slices.size());
    for (std::size_t i = 0; i < slices.size(); ++i) {
        for (const CloudPoint& point : slices[i]) {
            const Eigen::Vector3d ray = point.place.cast<double>().normalized();
            all[i].squares.noalias() += ray * ray.transpose();
            all[i].count += 1.0;
        }
    }
    return all;
}

/// The axis at a right angle to the normals of the slices' planes, each as much as it is told by.
std::optional<Eigen::Vector3d> startOfAxis(const std::vector<DirectionMoments>& slices)
{
    Eigen::Matrix3d normals = Eigen::Matrix3d::Zero();
    for (const DirectionMoments& slice : slices) {
        if (slice.count < 2.0)
            continue;
        const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(slice.squares);
        const Eigen::Vector3d normal = axes.eigenvectors().col(0);
        normals += (axes.eigenvalues()[1] - axes.eigenvalues()[0]) * normal * normal.transpose();
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(normals);
    if (!(axes.eigenvalues()[1] > kOnePlane * axes.eigenvalues()[2]))
        return std::nullopt;
    return axes.eigenvectors().col(0);
}

using Across = Eigen::Matrix<double, 3, 2>;

Across acrossOf(const Eigen::Vector3d& axis)
{
    Across across;
    across.col(0) = axis.unitOrthogonal();
    across.col(1) = axis.cross(across.col(0));
    return across;
}

/// The normal of a slice's plane through the axis, in the coordinates of `across`, and how far its points are off the
/// axis (Σ of squares).
std::pair<Eigen::Vector2d, double> normalAbout(const Across& across, const DirectionMoments& slice)
{
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(
        Eigen::Matrix2d(across.transpose() * slice.squares * across));
    return {axes.eigenvectors().col(0), axes.eigenvalues()[1]};
}

/// Gauss-Newton over the axis, each slice's own pitch eliminated.
Eigen::Vector3d refineAxis(Eigen::Vector3d axis, const std::vector<DirectionMoments>& slices)
{
    for (int iteration = 0; iteration < kMostIterations; ++iteration) {
        const Across across = acrossOf(axis);
        Eigen::Matrix2d information = Eigen::Matrix2d::Zero();
        Eigen::Vector2d gradient = Eigen::Vector2d::Zero();
        for (const DirectionMoments& slice : slices) {
            const auto [flat, off] = normalAbout(across, slice);
            if (off <= kSmallest * slice.count)
                continue;
            const Eigen::Vector3d normal = across * flat;
            const Eigen::Vector3d ahead = axis.cross(normal);
            const double cross = ahead.dot(slice.squares * axis);
            const double own = ahead.dot(slice.squares * ahead);
            information += flat * flat.transpose() * (axis.dot(slice.squares * axis) - cross * cross / own);
            gradient -= flat * (axis.dot(slice.squares * normal) - cross * ahead.dot(slice.squares * normal) / own);
        }
        const Eigen::Vector2d step = information.completeOrthogonalDecomposition().solve(-gradient);
        if (!step.allFinite())
            break;
        axis = (axis + across * step).normalized();
        if (step.norm() < 1e-13)
            break;
    }
    return axis;
}

Eigen::Vector3d snapped(const Eigen::Vector3d& axis)
{
    for (Eigen::Index i = 0; i < 3; ++i) {
        const Eigen::Vector3d along = Eigen::Vector3d::Unit(i) * (axis[i] < 0.0 ? -1.0 : 1.0);
        if ((axis - along).norm() < kSnapped)
            return along;
    }
    return axis;
}

/// Where each slice looks: to the side on which most of its points are, or, where that is not clear, the side nearer to
/// that of the slice before.
std::vector<Eigen::Vector3d> aheadOf(const Eigen::Vector3d& axis, const std::vector<DirectionMoments>& moments,
                                     const std::vector<CloudSlice>& slices)
{
    const Across across = acrossOf(axis);
    std::vector<Eigen::Vector3d> all(slices.size(), Eigen::Vector3d::Zero());
    Eigen::Vector3d before = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < slices.size(); ++i) {
        const auto [flat, off] = normalAbout(across, moments[i]);
        if (!(off > kSmallest * moments[i].count))
            continue;
        Eigen::Vector3d ahead = axis.cross(across * flat).normalized();
        double sum = 0.0;
        double both = 0.0;
        for (const CloudPoint& point : slices[i]) {
            const double part = ahead.dot(point.place.cast<double>().normalized());
            sum += part;
            both += std::abs(part);
        }
        const bool isClear = std::abs(sum) > kClearlyAhead * both || before.isZero(0.0);
        if ((isClear ? sum : ahead.dot(before)) < 0.0)
            ahead = -ahead;
        all[i] = before = ahead;
    }
    return all;
}

/// How much more often bearings about the axis rise than they fall in the order of the points.
double riseOf(const PitchAxis& axis, const std::vector<CloudSlice>& slices)
{
    double rises = 0.0;
    for (std::size_t i = 0; i < slices.size(); ++i) {
        const Eigen::Vector3d turn = axis.direction.cross(axis.ahead[i]);
        for (std::size_t k = 1; k < slices[i].size(); ++k) {
            const Eigen::Vector3d before = slices[i][k - 1].place.cast<double>();
            const double step = turn.dot(before.cross(slices[i][k].place.cast<double>()));
            rises += step > 0.0 ? 1.0 : step < 0.0 ? -1.0 : 0.0;
        }
    }
    return rises;
}

}  // namespace

std::optional<PitchAxis> fitPitchAxis(const std::vector<CloudSlice>& slices)
{
    const std::vector<DirectionMoments> moments = momentsOfSlices(slices);
    const auto start = startOfAxis(moments);
    if (!start)
        return std::nullopt;
    PitchAxis axis;
    axis.direction = snapped(refineAxis(*start, moments));
    axis.ahead = aheadOf(axis.direction, moments, slices);
    if (riseOf(axis, slices) < 0.0)
        axis.direction = -axis.direction;
    return axis;
}

}  // namespace planewright
