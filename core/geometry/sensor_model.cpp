// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/geometry/sensor_model.h"

#include <cmath>

#include "core/geometry/beam_covariance.h"
#include "core/types/square.h"

namespace planewright {

SensorModel sensorOf(const ScanDescription& description)
{
    SensorModel sensor{description.pitchAxisOffset, description.rangeMin, description.rangeMax};
    if (description.isTurned()) {
        sensor.attitude = description.attitude.toRotationMatrix();
        sensor.isTurned = true;
    }
    return sensor;
}

namespace {

BeamDirection directionOf(double bearing, double tilt)
{
    return {std::sin(bearing), std::cos(bearing), std::sin(tilt), std::cos(tilt)};
}

}  // namespace

Eigen::Vector3d toCartesian(double range, const BeamDirection& beam, const SensorModel& sensor)
{
    const double ahead = range * beam.sinBearing;
    // cos(φ − π/2) = sin φ and sin(φ − π/2) = −cos φ.
    const Eigen::Vector3d point{range * beam.cosBearing, ahead * beam.sinTilt + sensor.pitchAxisOffset * beam.cosTilt,
                                -ahead * beam.cosTilt + sensor.pitchAxisOffset * beam.sinTilt};
    return sensor.turned(point);
}

Eigen::Vector3d toCartesian(double range, double bearing, double tilt, const SensorModel& sensor)
{
    return toCartesian(range, directionOf(bearing, tilt), sensor);
}

Eigen::Matrix3d cartesianJacobian(double range, double bearing, double tilt, const SensorModel& sensor)
{
    const BeamDirection beam = directionOf(bearing, tilt);
    BeamJacobian<double> j;
    takeJacobian(range, beam.sinBearing, beam.cosBearing, beam.sinTilt, beam.cosTilt, sensor, j);
    Eigen::Matrix3d jacobian;
    jacobian << Eigen::Map<const Eigen::Vector3d>(j.byRange), Eigen::Map<const Eigen::Vector3d>(j.byBearing),
        Eigen::Map<const Eigen::Vector3d>(j.byTilt);
    if (sensor.isTurned)
        jacobian = (sensor.attitude * jacobian).eval();
    return jacobian;
}

Eigen::Matrix3d cartesianCovariance(double range, const BeamDirection& beam, const SensorModel& sensor,
                                    const NoiseParameters& noise)
{
    BeamJacobian<double> j;
    takeJacobian(range, beam.sinBearing, beam.cosBearing, beam.sinTilt, beam.cosTilt, sensor, j);
    double numbers[3][3];
    takeCovariance(j, noise.rangeVariance(range), square(noise.bearing), square(noise.pitch), numbers);
    Eigen::Matrix3d covariance;
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column)
            covariance(row, column) = numbers[row][column];
    }
    if (sensor.isTurned)
        covariance = (sensor.attitude * covariance * sensor.attitude.transpose()).eval();
    return covariance;
}

Eigen::Matrix3d cartesianCovariance(double range, double bearing, double tilt, const SensorModel& sensor,
                                    const NoiseParameters& noise)
{
    return cartesianCovariance(range, directionOf(bearing, tilt), sensor, noise);
}

}  // namespace planewright
