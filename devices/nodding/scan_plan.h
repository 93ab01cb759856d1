// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <chrono>

#include "core/types/angle.h"
#include "core/types/error.h"
#include "devices/laser.h"
#include "devices/tilt_unit.h"

namespace planewright {

/// What a nodding scanner is to take. The values here are those of Table VIII.
struct ScanPlan {
    /// How the head tilts.
    enum class Mode {
        Continuous,    ///< at constant speed, a slice each turn of the mirror
        StepAndStare,  ///< it moves, comes to rest, and stands still for each slice (section 3.2, Fig. 2)
    };
    Mode mode = Mode::Continuous;
    double firstPitch = degrees(10.0);    ///< φ of slice 0 [rad]
    double pitchStep = degrees(1.16);     ///< from slice to slice [rad]; may be negative
    int slices = 137;                     ///< at most kMaxSlices
    double firstBearing = 0.0;            ///< θ of the first beam [rad]
    double lastBearing = degrees(180.0);  ///< θ of the last beam [rad]
    int cluster = 1;                      ///< steps of the laser that give one range together, 1 to 99
    double pitchAxisOffset = 0.05;        ///< d_l of Eq. (6) [m]
    std::chrono::milliseconds settle{8};  ///< rest before a slice is taken, after the angle has come within tolerance
    double travelSpeed = degrees(90.0);   ///< between steps, and to where a scan begins [rad/s]

    double pitch(int slice) const { return firstPitch + slice * pitchStep; }
};

/// A plan in the steps of the devices that are to carry it out.
struct FittedPlan {
    LaserBeams steps;                       ///< of the laser; whole clusters
    int beams = 0;                          ///< ranges of a slice
    double firstBearing = 0.0;              ///< θ of the first range [rad]
    double bearingStep = 0.0;               ///< from range to range [rad]
    double pitchStep = 0.0;                 ///< from slice to slice, as the unit really does it [rad]
    int turnsPerSlice = 1;                  ///< of the mirror, in the continuous mode
    double sweepSpeed = 0.0;                ///< in the continuous mode [rad/s]; 0 in the other
    double points = 0.0;                    ///< beams times slices
    std::chrono::duration<double> time{0};  ///< from the first slice to the last, at least
};

/// Fits a plan to what a laser sees and a tilt unit may do.
///
/// A sweep has the nearest speed that the unit has, and its slices lie as far apart as that makes them.
///
/// The time is the least that the settings allow: a turn of the mirror for each slice; in StepAndStare the move between
/// two steps at the travel speed, the rest, and a turn, rounded up to whole turns, since the mirror waits for nobody.
/// Errors (Usage): a number of slices, a step or a speed that is no such thing, bearings or pitches out of reach (with
/// what is in reach), clusters that no laser has or that leave fewer than two ranges, a sweep faster or slower than the
/// unit can.
Result<FittedPlan> fitPlan(const ScanPlan& plan, const LaserLimits& laser, const TiltUnit& unit);

}  // namespace planewright
