// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <vector>

#include "core/simulation/acquisition_settings.h"
#include "core/simulation/scene.h"
#include "core/simulation/simulation_noise.h"
#include "core/types/recording.h"

namespace planewright {

/// A slice as the scanner reports it, and what its beams really hit.
struct SimulatedSlice {
    ScanSlice slice;          ///< ranges are not rounded
    std::vector<int> labels;  ///< of each beam: id of the TruePlane, kNoTruePlane or kNotPlanar
};

/// A scan as the scanner reports it, and what its beams really hit: labels[slice][beam].
struct SimulatedScan {
    Recording recording;
    std::vector<std::vector<int>> labels;
};

/// What is said once about scans with these settings.
ScanDescription describeScan(const AcquisitionSettings& settings);

/// One slice of a scan: the same as that slice of simulate() with the same arguments.
///
/// The slice reports its nominal tilt and bearings; its rays are cast with the errors of the noise added (Eq. (6)): one
/// pitch error for the slice, one bearing and one range error per beam. A range outside the limits is 0. A beam whose
/// footprint also hits a surface at clearly different depth gives a range between the two, labelled kNoTruePlane where
/// that is more than 3 σ off the surface that the centre of the beam hits.
SimulatedSlice simulateSlice(const Scene& scene, const AcquisitionSettings& settings, const SimulationNoise& noise,
                             std::uint64_t seed, int step);

/// A whole scan; the same seed gives the same bits.
SimulatedScan simulate(const Scene& scene, const AcquisitionSettings& settings, const SimulationNoise& noise,
                       std::uint64_t seed);

}  // namespace planewright
