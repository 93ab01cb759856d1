// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "core/calibration/observe_errors.h"
#include "core/calibration/scanner_errors.h"
#include "core/params/parameters.h"
#include "core/types/angle.h"
#include "core/types/error.h"
#include "core/types/recording.h"

namespace planewright {

/// Whether the zero of the pitch is taken from floors and walls, as if the scanner had stood level.
enum class LevelUse {
    Auto,    ///< of scans whose pitch axis is level within a degree
    Always,  ///< of all scans
    Never
};

/// What calibration takes for granted.
struct CalibrationSettings {
    LevelUse level = LevelUse::Auto;
    double buildingTolerance = degrees(0.1);  ///< how far floors are from level and walls from plumb, one sigma [rad]
};

/// An error of the scanner as its planes tell it.
struct CalibratedError {
    bool observed = false;
    double value = 0.0;  ///< the correction in all: what was in force and what was found [m, m, steps, steps]
    double sigma = 0.0;  ///< its standard deviation; not observed: what was reached, or infinite
    std::vector<ScannerError> tangled;  ///< not observed because these would explain the same
};

/// What one scan has told.
struct CalibratedScan {
    std::size_t planes = 0;  ///< that were seen well
    std::size_t points = 0;  ///< of these
    bool levelFound = false;
    bool usedAsLevel = false;  ///< for the zero of the pitch
    double pitchZero = 0.0;    ///< in all, by this scan alone [rad]
    double pitchZeroSigma = 0.0;
    double roll = 0.0;  ///< how far the pitch axis falls to the right [rad]
    double rollSigma = 0.0;
    int levelPlanes = 0;  ///< floors, ceilings, table tops
    int plumbPlanes = 0;  ///< walls
};

struct Calibration {
    std::array<CalibratedError, kScannerErrors> errors;
    bool pitchZeroObserved = false;
    double pitchZero = 0.0;  ///< in all [rad], if the scanner stood level
    double pitchZeroSigma = 0.0;
    double pitchNoise = 0.0;    ///< found, of a slice; the largest of the scans [rad]
    bool nodsBothWays = false;  ///< in one scan at least
    double disagreement =
        1.0;  ///< factor that all uncertainties have in them: how much more planes disagree than that explains
    double unevenness = 0.0;  ///< found: what planes are off in a way that looks like the scanner's errors [m]
    std::vector<CalibratedScan> scans;  ///< in the order of the recordings
    SensorParameters sensor;            ///< corrections for `sensor.*`: as found where observed, as in force elsewhere
};

/// Estimates what scans of one scanner tell of its errors, from `parameters.sensor` on.
///
/// The planes of each scan are extracted with the corrections so far, then corrections and planes are estimated
/// together from all points, and both are repeated until the corrections stay. The zero of the pitch follows from
/// floors, ceilings and walls, as if the scanner had stood level.
/// Errors: GateFailed where no scan has a plane that is seen well enough.
Result<Calibration> calibrate(std::span<const Recording> recordings, const Parameters& parameters,
                              const CalibrationSettings& settings = {});

}  // namespace planewright
