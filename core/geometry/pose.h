// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace planewright {

using Vector6d = Eigen::Matrix<double, 6, 1>;
using Matrix6d = Eigen::Matrix<double, 6, 6>;

/// Where a stop stands: a point p of the stop's frame is R p + t of the map's [m].
///
/// The error of a pose is e = (θ, τ): R ← exp(θ) R and t ← t + τ, both along the map's axes [rad, m]. A covariance of a
/// pose is that of e, the rotation first.
struct Pose {
    Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
    Eigen::Vector3d translation = Eigen::Vector3d::Zero();

    Eigen::Vector3d operator*(const Eigen::Vector3d& point) const { return rotation * point + translation; }
    Pose operator*(const Pose& inner) const;
    Pose inverse() const;
};

/// [v]×: crossMatrix(v) · w = v × w.
Eigen::Matrix3d crossMatrix(const Eigen::Vector3d& v);

/// The rotation about a vector by its length [rad], and back; the length is at most π.
Eigen::Quaterniond rotationAbout(const Eigen::Vector3d& vector);
Eigen::Vector3d rotationVector(const Eigen::Quaterniond& rotation);

/// The pose with an error added; and the error that leads from a pose to another.
Pose withError(const Pose& pose, const Vector6d& error);
Vector6d errorBetween(const Pose& from, const Pose& to);

/// Turns an error of a pose (θ, τ) into that of what stands at `offset` from it and turns with it: τ + θ × offset.
Matrix6d carriedBy(const Eigen::Vector3d& offset);

/// The covariance of a pose with its axes turned.
Matrix6d turnedBy(const Eigen::Quaterniond& rotation, const Matrix6d& covariance);

/// A motion from one stop to the next, in the frame of the first, with the covariance of its error along the axes
/// there.
struct Motion {
    Pose pose;
    Matrix6d covariance = Matrix6d::Zero();  ///< [rad², rad·m, m²]
};

/// What wheels tell of a motion: its errors grow with the way that was driven.
struct OdometryNoise {
    double way = 0.02;                    ///< standard deviation of the place, as share of the way
    double turnPerRootMetre = 5.5192e-3;  ///< of the heading: 1° on 10 m [rad/√m]
    double tilt = 3.5e-3;                 ///< of roll and pitch from one stop to the next: 0.2° [rad]
    double height = 5e-3;                 ///< of the height [m]
    double least = 2e-3;                  ///< of the place, however short the way [m]
};

/// The covariance of a motion under this noise; z is up. The way is the motion's length.
Matrix6d odometryCovariance(const Pose& motion, const OdometryNoise& noise);

}  // namespace planewright
