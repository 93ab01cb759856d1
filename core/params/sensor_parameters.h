// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <tuple>

#include "core/params/parameter.h"
#include "core/types/angle.h"

namespace planewright {

/// What a calibration has found out about the scanner: corrections of what its recordings say; all zero, none.
struct SensorParameters {
    double pitchZero = 0.0;
    double rangeOffset = 0.0;
    double leverArmCorrection = 0.0;
    double sweepTurn = 0.0;
    double pitchDelay = 0.0;

    /// True where a recording is right as it is.
    bool correctsNothing() const
    {
        return pitchZero == 0.0 && rangeOffset == 0.0 && leverArmCorrection == 0.0 && sweepTurn == 0.0 &&
               pitchDelay == 0.0;
    }

    static constexpr auto describe()
    {
        return std::tuple{
            Parameter{"sensor.pitch-zero", &SensorParameters::pitchZero, Unit::Angle,
                      Range{degrees(-45.0), degrees(45.0)}, "", "Is added to every measured pitch."},
            Parameter{"sensor.range-offset", &SensorParameters::rangeOffset, Unit::Metre, Range{-1.0, 1.0}, "",
                      "Is added to every return."},
            Parameter{"sensor.lever-arm-correction", &SensorParameters::leverArmCorrection, Unit::Metre,
                      Range{-1.0, 1.0}, "d_l",
                      "Is added to the distance from the pitch axis to the laser that the recording gives."},
            Parameter{"sensor.sweep-turn", &SensorParameters::sweepTurn, Unit::None, Range{-4.0, 4.0}, "",
                      "How far the head nods on while the laser sweeps, in steps from slice to slice, beyond what the "
                      "recording says."},
            Parameter{"sensor.pitch-delay", &SensorParameters::pitchDelay, Unit::None, Range{-4.0, 4.0}, "",
                      "How far the head nods on between the moment of the measured pitch and the first beam, in steps "
                      "from slice to slice."},
        };
    }
};

static_assert(defaultsAreInRange<SensorParameters>());

}  // namespace planewright
