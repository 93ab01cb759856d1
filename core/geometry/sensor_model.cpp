// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/geometry/sensor_model.h"

#include <cmath>

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

Eigen::Matrix3d jacobianAt(double range, const BeamDirection& beam, const SensorModel& sensor)
{
    const auto [st, ct, sp, cp] = beam;
    const double dl = sensor.pitchAxisOffset;
    Eigen::Matrix3d j;
    j << ct, -range * st, 0.0,                                //
        st * sp, range * ct * sp, range * st * cp - dl * sp,  //
        -st * cp, -range * ct * cp, range * st * sp + dl * cp;
    return j;
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
    return jacobianAt(range, directionOf(bearing, tilt), sensor);
}

Eigen::Matrix3d cartesianCovariance(double range, const BeamDirection& beam, const SensorModel& sensor,
                                    const NoiseParameters& noise)
{
    const Eigen::Matrix3d j = jacobianAt(range, beam, sensor);
    const Eigen::Vector3d variances{noise.rangeVariance(range), noise.bearing * noise.bearing,
                                    noise.pitch * noise.pitch};
    return j * variances.asDiagonal() * j.transpose();
}

Eigen::Matrix3d cartesianCovariance(double range, double bearing, double tilt, const SensorModel& sensor,
                                    const NoiseParameters& noise)
{
    return cartesianCovariance(range, directionOf(bearing, tilt), sensor, noise);
}

}  // namespace planewright
