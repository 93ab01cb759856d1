// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "core/types/beam_table.h"
#include "core/types/scan_slice.h"

namespace planewright {

/// Most slices a recording may hold, and most beams a slice may hold.
inline constexpr int kMaxSlices = 65536;
inline constexpr int kMaxBeams = 65536;
/// Most ranges in all: far beyond any scanner, and few enough that a hostile file cannot take the memory (2^27 are
/// 1 GiB).
inline constexpr std::size_t kMaxRanges = std::size_t{1} << 27;

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
    std::shared_ptr<const BeamTable> beamTable{};            ///< of beams that are not evenly spaced; else empty
    /// From the frame of Eq. (6), whose x is the pitch axis, to the recording's own, in which planes are told: not the
    /// identity where the axis is another one, as that of a scanner that turns about the vertical.
    Eigen::Quaterniond attitude = Eigen::Quaterniond::Identity();

    bool isTurned() const { return attitude.vec() != Eigen::Vector3d::Zero(); }
};

/// A whole scan in memory: its description and its slices in order of measurement.
struct Recording {
    ScanDescription description;
    std::vector<ScanSlice> slices;
};

}  // namespace planewright
