// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/geometry/sensor_model.h"

#include <array>
#include <cmath>
#include <cstddef>

namespace planewright {

SensorModel sensorOf(const ScanDescription& description)
{
    return {description.pitchAxisOffset, description.rangeMin, description.rangeMax};
}

namespace {

BeamDirection directionOf(double bearing, double tilt)
{
    return {std::sin(bearing), std::cos(bearing), std::sin(tilt), std::cos(tilt)};
}

/// The columns of J.
struct Jacobian {
    std::array<double, 3> byRange;
    std::array<double, 3> byBearing;
    std::array<double, 3> byTilt;
};

Jacobian jacobianAt(double range, const BeamDirection& beam, const SensorModel& sensor)
{
    const double st = beam.sinBearing;
    const double ct = beam.cosBearing;
    const double sp = beam.sinTilt;
    const double cp = beam.cosTilt;
    const double dl = sensor.pitchAxisOffset;
    return {{ct, st * sp, -st * cp},
            {-range * st, range * ct * sp, -range * ct * cp},
            {0.0, range * st * cp - dl * sp, range * st * sp + dl * cp}};
}

}  // namespace

Eigen::Vector3d toCartesian(double range, const BeamDirection& beam, const SensorModel& sensor)
{
    const double ahead = range * beam.sinBearing;
    // cos(φ − π/2) = sin φ and sin(φ − π/2) = −cos φ.
    return {range * beam.cosBearing, ahead * beam.sinTilt + sensor.pitchAxisOffset * beam.cosTilt,
            -ahead * beam.cosTilt + sensor.pitchAxisOffset * beam.sinTilt};
}

Eigen::Vector3d toCartesian(double range, double bearing, double tilt, const SensorModel& sensor)
{
    return toCartesian(range, directionOf(bearing, tilt), sensor);
}

Eigen::Matrix3d cartesianJacobian(double range, double bearing, double tilt, const SensorModel& sensor)
{
    const Jacobian j = jacobianAt(range, directionOf(bearing, tilt), sensor);
    Eigen::Matrix3d jacobian;
    jacobian << Eigen::Map<const Eigen::Vector3d>(j.byRange.data()),
        Eigen::Map<const Eigen::Vector3d>(j.byBearing.data()), Eigen::Map<const Eigen::Vector3d>(j.byTilt.data());
    return jacobian;
}

Eigen::Matrix3d cartesianCovariance(double range, const BeamDirection& beam, const SensorModel& sensor,
                                    const NoiseParameters& noise)
{
    // J diag(variances) Jᵀ number by number: products of matrices this small wait for what was stored just before. The
    // last row adds up in the order in which such a product does.
    const Jacobian j = jacobianAt(range, beam, sensor);
    const double ofRange = noise.rangeVariance(range);
    const double ofBearing = noise.bearing * noise.bearing;
    const double ofTilt = noise.pitch * noise.pitch;
    Eigen::Matrix3d covariance;
    for (std::size_t row = 0; row < 3; ++row) {
        for (std::size_t column = 0; column < 3; ++column) {
            const double first = j.byRange[row] * ofRange * j.byRange[column];
            const double second = j.byBearing[row] * ofBearing * j.byBearing[column];
            const double third = j.byTilt[row] * ofTilt * j.byTilt[column];
            covariance(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(column)) =
                row < 2 ? first + second + third : first + (second + third);
        }
    }
    return covariance;
}

Eigen::Matrix3d cartesianCovariance(double range, double bearing, double tilt, const SensorModel& sensor,
                                    const NoiseParameters& noise)
{
    return cartesianCovariance(range, directionOf(bearing, tilt), sensor, noise);
}

}  // namespace planewright
