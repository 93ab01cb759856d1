// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tests/benchmarks/plane_information.h"

#include "core/planes/end_point_cost.h"

namespace planewright {

PlaneInformation::PlaneInformation(const KnownPlane& plane, const SimulationNoise& noise, const SensorModel& sensor,
                                   PitchNoise pitch)
    : plane_(plane), noise_(noise), sensor_(sensor), pitch_(pitch), tangents_(tangentsOf(plane.normal))
{
}

void PlaneInformation::add(double range, double bearing, double tilt)
{
    const Eigen::Vector3d point = toCartesian(range, bearing, tilt, sensor_);
    const Eigen::Vector3d gradient =
        cartesianJacobian(range, bearing, tilt, sensor_).transpose() * plane_.normal;  // by range, bearing, tilt
    const double rangeSigma = noise_.rangeSigma(range);
    double variance = gradient[0] * gradient[0] * rangeSigma * rangeSigma +
                      gradient[1] * gradient[1] * noise_.bearing * noise_.bearing;
    if (pitch_ == PitchNoise::Independent)
        variance += gradient[2] * gradient[2] * noise_.pitch * noise_.pitch;

    const Eigen::Vector3d row{tangents_.col(0).dot(point), tangents_.col(1).dot(point), -1.0};
    sliceInformation_ += row * row.transpose() / variance;
    coupling_ += gradient[2] / variance * row;
    pitchInformation_ += gradient[2] * gradient[2] / variance;
}

void PlaneInformation::endSlice()
{
    information_ += sliceInformation_;
    if (pitch_ == PitchNoise::Common) {
        const double variance = noise_.pitch * noise_.pitch;
        information_ -= variance / (1.0 + variance * pitchInformation_) * coupling_ * coupling_.transpose();
    }
    sliceInformation_.setZero();
    coupling_.setZero();
    pitchInformation_ = 0.0;
}

Eigen::Vector3d errorOf(const KnownPlane& estimate, const KnownPlane& truth)
{
    const double side = estimate.normal.dot(truth.normal) < 0.0 ? -1.0 : 1.0;
    Eigen::Vector3d error;
    error.head<2>() = tangentsOf(truth.normal).transpose() * (side * estimate.normal);
    error[2] = side * estimate.distance - truth.distance;
    return error;
}

}  // namespace planewright
