// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/types/scan_slice.h"

namespace planewright {

/// Most slices a recording may hold, and most beams a slice may hold.
inline constexpr int kMaxSlices = 65536;
inline constexpr int kMaxBeams = 65536;

/// What is said once about a scan: its scanner and the geometry of its beams.
struct ScanDescription {
    std::string scanner;           ///< the scanner's name as the recording gives it; empty if unknown
    double firstBearing = 0.0;     ///< bearing of beam 0 [rad]
    double bearingStep = 0.0;      ///< angle between neighbouring beams [rad]
    int beams = 0;                 ///< beams in every slice
    double rangeMin = 0.0;         ///< nearest range that counts as a return [m]
    double rangeMax = 0.0;         ///< farthest range that counts as a return [m]
    double pitchAxisOffset = 0.0;  ///< d_l of Eq. (6): from the pitch axis to the laser [m]
    std::vector<std::pair<std::string, std::string>> extra;  ///< unknown header keys, kept as they came
};

/// A whole scan in memory: its description and its slices in order of measurement.
struct Recording {
    ScanDescription description;
    std::vector<ScanSlice> slices;
};

}  // namespace planewright
