// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/geometry/pose.h"

#include <cmath>

#include "core/types/square.h"

namespace planewright {

Pose Pose::operator*(const Pose& inner) const
{
    return {(rotation * inner.rotation).normalized(), rotation * inner.translation + translation};
}

Pose Pose::inverse() const
{
    const Eigen::Quaterniond back = rotation.conjugate();
    return {back, -(back * translation)};
}

Eigen::Matrix3d crossMatrix(const Eigen::Vector3d& v)
{
    Eigen::Matrix3d matrix;
    matrix << 0.0, -v.z(), v.y(),  //
        v.z(), 0.0, -v.x(),        //
        -v.y(), v.x(), 0.0;
    return matrix;
}

Eigen::Quaterniond rotationAbout(const Eigen::Vector3d& vector)
{
    const double angle = vector.norm();
    constexpr double kSmall = 1e-9;  // below it sin x = x to the last bit
    const double scale = angle > kSmall ? std::sin(0.5 * angle) / angle : 0.5;
    return Eigen::Quaterniond(std::cos(0.5 * angle), scale * vector.x(), scale * vector.y(), scale * vector.z());
}

Eigen::Vector3d rotationVector(const Eigen::Quaterniond& rotation)
{
    const double sign = rotation.w() < 0.0 ? -1.0 : 1.0;
    const Eigen::Vector3d axis = sign * rotation.vec();
    const double sine = axis.norm();
    constexpr double kSmall = 1e-9;
    return sine > kSmall ? Eigen::Vector3d(2.0 * std::atan2(sine, sign * rotation.w()) / sine * axis)
                         : Eigen::Vector3d(2.0 * axis);
}

Pose withError(const Pose& pose, const Vector6d& error)
{
    return {(rotationAbout(error.head<3>()) * pose.rotation).normalized(), pose.translation + error.tail<3>()};
}

Vector6d errorBetween(const Pose& from, const Pose& to)
{
    Vector6d error;
    error << rotationVector(to.rotation * from.rotation.conjugate()), to.translation - from.translation;
    return error;
}

Matrix6d carriedBy(const Eigen::Vector3d& offset)
{
    Matrix6d matrix = Matrix6d::Identity();
    matrix.bottomLeftCorner<3, 3>() = -crossMatrix(offset);
    return matrix;
}

Matrix6d turnedBy(const Eigen::Quaterniond& rotation, const Matrix6d& covariance)
{
    const Eigen::Matrix3d r = rotation.toRotationMatrix();
    Matrix6d both = Matrix6d::Zero();
    both.topLeftCorner<3, 3>() = r;
    both.bottomRightCorner<3, 3>() = r;
    return both * covariance * both.transpose();
}

Matrix6d odometryCovariance(const Pose& motion, const OdometryNoise& noise)
{
    const double way = motion.translation.norm();
    const double place = square(noise.way * way) + square(noise.least);
    // However short the way, the heading is not known better than roll and pitch.
    const double turn = square(noise.turnPerRootMetre) * way + square(noise.tilt);
    Vector6d variances;
    variances << square(noise.tilt), square(noise.tilt), turn, place, place, square(noise.height);
    Matrix6d covariance = variances.asDiagonal();
    // Half of the tilt is where the first stop stands: a way that is level there leads up or down, seen from it.
    const double ofFirst = 0.5 * square(noise.tilt);
    const Eigen::Vector3d& t = motion.translation;
    covariance(5, 5) += ofFirst * t.head<2>().squaredNorm();
    covariance(0, 5) = covariance(5, 0) = ofFirst * t.y();
    covariance(1, 5) = covariance(5, 1) = -ofFirst * t.x();
    return covariance;
}

}  // namespace planewright
