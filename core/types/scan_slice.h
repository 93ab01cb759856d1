// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <chrono>
#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

namespace planewright {

/// One sweep of the laser at one tilt step: the scan points of step k in polar form.
struct ScanSlice {
    int step = 0;                       ///< number of the scan step, from 0; gaps are missing steps
    std::chrono::microseconds time{0};  ///< moment of beam 0 since the start of the scan
    double tilt = 0.0;                  ///< pitch φ of Eq. (6) at beam 0 [rad]; π/2 looks level, less looks down
    std::optional<double> tiltEnd;      ///< pitch at the last beam [rad], linear between, where the head nods on
    double firstBearing = 0.0;          ///< bearing θ of beam 0 [rad]
    bool ownBearing = false;            ///< firstBearing is this slice's own, not the recording's (interlaced scanners)
    double bearingStep = 0.0;           ///< angle between neighbouring beams [rad]
    std::vector<double> ranges;         ///< range ρ of each beam [m]; 0 = no return
    std::optional<double> tiltCommanded;  ///< pitch that the tilt unit was told to take [rad], where it is known
    bool angleSuspect = false;            ///< the pitch may be wrong: kept in recordings, and no planes are made of it
    bool timeSuspect = false;             ///< the time may be wrong
    bool retaken = false;                 ///< taken again after a fault
    /// Bearing of each beam [rad], rising, where they are not evenly spaced; firstBearing and bearingStep are then that
    /// of the first beam and the mean step of the recording.
    std::shared_ptr<const std::vector<double>> bearings{};

    /// Bearing θ of a beam [rad].
    double bearing(std::size_t beam) const
    {
        return bearings ? (*bearings)[beam] : firstBearing + static_cast<double>(beam) * bearingStep;
    }

    /// Pitch φ of a beam [rad].
    double tiltAt(std::size_t beam) const
    {
        if (!tiltEnd || ranges.size() < 2)
            return tilt;
        return tilt + (*tiltEnd - tilt) * (static_cast<double>(beam) / static_cast<double>(ranges.size() - 1));
    }
};

}  // namespace planewright
