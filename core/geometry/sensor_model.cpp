// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/geometry/sensor_model.h"

#include <cmath>

namespace planewright {

SensorModel sensorOf(const ScanDescription& description)
{
    return {description.pitchAxisOffset, description.rangeMin, description.rangeMax};
}

Eigen::Vector3d toCartesian(double range, double bearing, double tilt, const SensorModel& sensor)
{
    const double ahead = range * std::sin(bearing);
    // cos(φ − π/2) = sin φ and sin(φ − π/2) = −cos φ.
    return {range * std::cos(bearing), ahead * std::sin(tilt) + sensor.pitchAxisOffset * std::cos(tilt),
            -ahead * std::cos(tilt) + sensor.pitchAxisOffset * std::sin(tilt)};
}

Eigen::Matrix3d cartesianJacobian(double range, double bearing, double tilt, const SensorModel& sensor)
{
    const double st = std::sin(bearing);
    const double ct = std::cos(bearing);
    const double sp = std::sin(tilt);
    const double cp = std::cos(tilt);
    const double dl = sensor.pitchAxisOffset;
    Eigen::Matrix3d j;
    j << ct, -range * st, 0.0,                                //
        st * sp, range * ct * sp, range * st * cp - dl * sp,  //
        -st * cp, -range * ct * cp, range * st * sp + dl * cp;
    return j;
}

Eigen::Matrix3d cartesianCovariance(double range, double bearing, double tilt, const SensorModel& sensor,
                                    const NoiseParameters& noise)
{
    const Eigen::Matrix3d j = cartesianJacobian(range, bearing, tilt, sensor);
    const Eigen::Vector3d variances{noise.rangeVariance(range), noise.bearing * noise.bearing,
                                    noise.pitch * noise.pitch};
    return j * variances.asDiagonal() * j.transpose();
}

}  // namespace planewright
