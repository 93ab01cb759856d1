// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>

#include "core/geometry/sensor_model.h"
#include "core/simulation/simulation_noise.h"

namespace planewright {

/// Whose the pitch error is: one for all points of a slice, or one for each point.
enum class PitchNoise { Common, Independent };

/// A plane that is known: n·p = d with |n| = 1, in the sensor's frame [m].
struct KnownPlane {
    Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
    double distance = 0.0;  ///< d [m]
};

/// Fisher information that scan points carry about their plane: its inverse is the Cramér-Rao bound.
///
/// Unknowns are two angles along tangentsOf(normal) and d [rad, rad, m]. A pitch error that is common to a slice is one
/// more unknown of that slice, with its variance known, and is eliminated when the slice ends (Schur complement).
class PlaneInformation {
public:
    PlaneInformation(const KnownPlane& plane, const SimulationNoise& noise, const SensorModel& sensor,
                     PitchNoise pitch = PitchNoise::Common);

    /// Adds a point of the plane at this range [m], bearing and tilt [rad].
    void add(double range, double bearing, double tilt);

    /// Closes the slice: the points that follow have another pitch error.
    void endSlice();

    /// F of all slices that were closed [1/rad², 1/(rad·m), 1/m²].
    const Eigen::Matrix3d& information() const { return information_; }

private:
    KnownPlane plane_;
    SimulationNoise noise_;
    SensorModel sensor_;
    PitchNoise pitch_;
    Eigen::Matrix<double, 3, 2> tangents_;
    Eigen::Matrix3d information_ = Eigen::Matrix3d::Zero();
    Eigen::Matrix3d sliceInformation_ = Eigen::Matrix3d::Zero();
    Eigen::Vector3d coupling_ = Eigen::Vector3d::Zero();
    double pitchInformation_ = 0.0;
};

/// Error of an estimated plane in the unknowns of PlaneInformation, whichever side its normal looks to.
Eigen::Vector3d errorOf(const KnownPlane& estimate, const KnownPlane& truth);

}  // namespace planewright
