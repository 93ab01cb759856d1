// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <chrono>
#include <span>
#include <string_view>

#include "core/types/angle.h"
#include "core/types/error.h"

namespace planewright {

/// How a nodding scanner takes a scan. The values here are those of Table VIII.
struct AcquisitionSettings {
    double firstTilt = degrees(10.0);             ///< pitch φ of slice 0 [rad]; π/2 looks level, less looks down
    double tiltStep = degrees(1.16);              ///< between slices [rad]
    int slices = 137;                             ///< at most kMaxSlices
    double firstBearing = 0.0;                    ///< bearing θ of beam 0 [rad]
    double bearingStep = degrees(0.25);           ///< between beams [rad]
    int beams = 721;                              ///< at most kMaxBeams
    double rangeMin = 0.1;                        ///< [m]; nearer is no return
    double rangeMax = 30.0;                       ///< [m]; farther is no return
    double pitchAxisOffset = 0.05;                ///< d_l of Eq. (6) [m]
    std::chrono::microseconds sliceTime{25'000};  ///< from one slice to the next
    bool continuous = false;                      ///< the head nods on during a slice, to the tilt of the next
};

/// Settings with a name to ask for them by.
struct NamedSettings {
    std::string_view name;
    AcquisitionSettings settings;
};

/// "table8": Table VIII; "table10-1" to "table10-8": the columns of Table X; "largest": 1024 slices of 1081 beams.
std::span<const NamedSettings> acquisitionPresets();

/// One of acquisitionPresets() by name; an unknown name is a Usage error that lists the known ones.
Result<AcquisitionSettings> acquisitionSettings(std::string_view name);

}  // namespace planewright
