// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

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
};

}  // namespace planewright
