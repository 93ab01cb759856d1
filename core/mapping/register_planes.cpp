// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/mapping/register_planes.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/SVD>

namespace planewright {

namespace {

/// The inverse over the directions that are known at all.
Eigen::Matrix3d inverseWhereKnown(const Eigen::Matrix3d& information)
{
    constexpr double kLeastShare = 1e-9;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solved{information};
    Eigen::Vector3d inverse = solved.eigenvalues();
    for (double& value : inverse)
        value = value > 0.0 && value > kLeastShare * solved.eigenvalues()[2] ? 1.0 / value : 0.0;
    return solved.eigenvectors() * inverse.asDiagonal() * solved.eigenvectors().transpose();
}

/// What is left of information, never below zero by rounding.
Eigen::Matrix3d rest(const Eigen::Matrix3d& whole, const Eigen::Matrix3d& taken)
{
    constexpr double kRounding = 1e-9;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solved{whole - taken};
    const double least = kRounding * whole.trace();
    const Eigen::Vector3d kept =
        (solved.eigenvalues().array() > least).select(solved.eigenvalues(), Eigen::Vector3d::Zero());
    return solved.eigenvectors() * kept.asDiagonal() * solved.eigenvectors().transpose();
}

/// The normal equations of the pairs about a pose; χ² of each pair on the way.
struct NormalEquations {
    Matrix6d information = Matrix6d::Zero();
    Vector6d gradient = Vector6d::Zero();
    std::vector<double> pairChiSquares;

    NormalEquations(std::span<const MatchedPlanes> pairs, const Pose& pose)
    {
        for (const MatchedPlanes& pair : pairs) {
            const Eigen::Vector3d middle = pose * pair.middle;
            const Pose fromMiddle{pose.rotation, pose.translation - middle};
            const UncertainPlane seen = inMap(pair.seen, fromMiddle);
            const UncertainPlane known = seenFrom(pair.known, middle);
            const Eigen::Vector3d apart = difference(seen, known);
            const Matrix3x6d jacobian = poseJacobian(seen, fromMiddle);
            const Eigen::LLT<Eigen::Matrix3d> covariance(seen.covariance + covarianceIn(seen, known));
            const Eigen::Vector3d weighted = covariance.solve(apart);
            information += jacobian.transpose() * covariance.solve(jacobian);
            gradient += jacobian.transpose() * weighted;
            pairChiSquares.push_back(apart.dot(weighted));
        }
    }
};

/// A pose near the best one: rotation by the normals, then the shift that the distances ask for, the shortest one.
Pose closedFormStart(std::span<const MatchedPlanes> pairs, const std::optional<PosePrior>& prior)
{
    Pose start = prior ? prior->pose : Pose{};
    std::vector<Eigen::Vector3d> seen;
    std::vector<Eigen::Vector3d> known;
    std::vector<double> weights;
    for (const MatchedPlanes& pair : pairs) {
        seen.push_back(pair.seen.normal);
        known.push_back(pair.known.normal);
        weights.push_back(1.0 / (pair.seen.covariance.topLeftCorner<2, 2>().trace() +
                                 pair.known.covariance.topLeftCorner<2, 2>().trace()));
    }
    if (const auto rotation = bestRotation(seen, known, weights))
        start.rotation = *rotation;
    Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
    Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
    for (const MatchedPlanes& pair : pairs) {
        const Eigen::Vector3d normal = start.rotation * pair.seen.normal;
        const Eigen::Vector3d middle = start * pair.middle;
        const UncertainPlane here = inMap(pair.seen, {start.rotation, start.translation - middle});
        const UncertainPlane there = seenFrom(pair.known, middle);
        const double miss = there.distance - here.distance;
        const double weight = 1.0 / (here.covariance(2, 2) + there.covariance(2, 2));
        information += weight * normal * normal.transpose();
        gradient += weight * miss * normal;
    }
    // Directions fixed a hundred times worse than the best are left to the prior: they would start far off.
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solved{information};
    for (int axis = 0; axis < 3; ++axis) {
        const double known2 = solved.eigenvalues()[axis];
        const Eigen::Vector3d direction = solved.eigenvectors().col(axis);
        if (known2 > 1e-4 * solved.eigenvalues()[2] && known2 > 0.0)
            start.translation += direction.dot(gradient) / known2 * direction;
    }
    return start;
}

}  // namespace

PoseStrength poseStrength(const Matrix6d& information)
{
    const Eigen::Matrix3d turn = information.topLeftCorner<3, 3>();
    const Eigen::Matrix3d shift = information.bottomRightCorner<3, 3>();
    const Eigen::Matrix3d both = information.topRightCorner<3, 3>();
    return {strengthOf(rest(shift, both.transpose() * inverseWhereKnown(turn) * both)),
            strengthOf(rest(turn, both * inverseWhereKnown(shift) * both.transpose()))};
}

std::optional<Eigen::Quaterniond> bestRotation(std::span<const Eigen::Vector3d> from,
                                               std::span<const Eigen::Vector3d> to, std::span<const double> weights)
{
    Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
    for (std::size_t i = 0; i < from.size(); ++i)
        sum += weights[i] * to[i] * from[i].transpose();
    const Eigen::JacobiSVD<Eigen::Matrix3d> svd(sum, Eigen::ComputeFullU | Eigen::ComputeFullV);
    constexpr double kLeastShare = 1e-2;  // directions about a tenth of a radian apart
    const Eigen::Vector3d singular = svd.singularValues();
    if (!(singular[0] > 0.0) || singular[1] < kLeastShare * singular[0])
        return std::nullopt;
    const double handed = svd.matrixU().determinant() * svd.matrixV().determinant() < 0.0 ? -1.0 : 1.0;
    return Eigen::Quaterniond(svd.matrixU() * Eigen::Vector3d(1.0, 1.0, handed).asDiagonal() *
                              svd.matrixV().transpose());
}

std::optional<Registration> registerPlanes(std::span<const MatchedPlanes> pairs, const std::optional<PosePrior>& prior)
{
    constexpr int kMostIterations = 20;
    constexpr double kStill = 1e-10;  // [rad, m]
    const Matrix6d priorInformation =
        prior ? Matrix6d(prior->covariance.llt().solve(Matrix6d::Identity())) : Matrix6d(Matrix6d::Zero());

    Registration found;
    found.pose = closedFormStart(pairs, prior);
    Eigen::LLT<Matrix6d> information;
    for (int iteration = 0; iteration < kMostIterations; ++iteration) {
        NormalEquations equations(pairs, found.pose);
        found.information = equations.information;
        found.strength = poseStrength(found.information);
        if (!prior && !found.strength.fixesAll())
            return std::nullopt;
        Vector6d gradient = equations.gradient;
        found.priorChiSquare = 0.0;
        if (prior) {
            const Vector6d miss = errorBetween(found.pose, prior->pose);
            gradient += priorInformation * miss;
            found.priorChiSquare = miss.dot(priorInformation * miss);
        }
        found.pairChiSquares = std::move(equations.pairChiSquares);
        information.compute(found.information + priorInformation);
        const Vector6d step = information.solve(gradient);
        if (!step.allFinite())
            return std::nullopt;
        found.pose = withError(found.pose, step);
        if (step.cwiseAbs().maxCoeff() < kStill)
            break;
    }
    found.covariance = information.solve(Matrix6d::Identity());
    found.chiSquare = found.priorChiSquare;
    for (const double each : found.pairChiSquares)
        found.chiSquare += each;
    return found;
}

}  // namespace planewright
