// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>

#include "core/params/parameters.h"
#include "core/types/recording.h"

namespace planewright {

/// Geometry of the nodding scanner, Eq. (6), and the ranges that count as returns.
struct SensorModel {
    double pitchAxisOffset = 0.05;  ///< d_l [m]
    double rangeMin = 0.1;          ///< [m]
    double rangeMax = 30.0;         ///< [m]
    /// From the frame of Eq. (6) to the recording's; the identity unless isTurned.
    Eigen::Matrix3d attitude = Eigen::Matrix3d::Identity();
    bool isTurned = false;

    /// A direction or point of the frame of Eq. (6) in the recording's.
    Eigen::Vector3d turned(const Eigen::Vector3d& vector) const
    {
        return isTurned ? Eigen::Vector3d(attitude * vector) : vector;
    }
    /// True where a range is a return: not zero and within the limits.
    bool hasEcho(double range) const { return range > 0.0 && range >= rangeMin && range <= rangeMax; }
};

/// The sensor model that a recording's description gives.
SensorModel sensorOf(const ScanDescription& description);

/// A beam's bearing θ and tilt φ by their sines and cosines: what Eq. (6) and its derivatives need of them.
struct BeamDirection {
    double sinBearing = 0.0;
    double cosBearing = 1.0;
    double sinTilt = 1.0;
    double cosTilt = 0.0;
};

/// The same as below for a direction worked out before.
Eigen::Vector3d toCartesian(double range, const BeamDirection& beam, const SensorModel& sensor);
Eigen::Matrix3d cartesianCovariance(double range, const BeamDirection& beam, const SensorModel& sensor,
                                    const NoiseParameters& noise);

/// The point of a range [m] at a bearing θ and a tilt φ [rad], Eq. (6): x right, y forward, z up, origin on the pitch
/// axis [m]; turned to the recording's frame, as all below.
Eigen::Vector3d toCartesian(double range, double bearing, double tilt, const SensorModel& sensor);

/// J of Eq. (15): derivatives of Eq. (6) by range, bearing and tilt, one column each. Entry (3,1) is −sin θ cos φ; the
/// paper prints it without the sign.
Eigen::Matrix3d cartesianJacobian(double range, double bearing, double tilt, const SensorModel& sensor);

/// C of Eq. (15) [m²]: the noise of range, bearing and tilt carried through J. Singular on the pitch axis.
Eigen::Matrix3d cartesianCovariance(double range, double bearing, double tilt, const SensorModel& sensor,
                                    const NoiseParameters& noise);

}  // namespace planewright
