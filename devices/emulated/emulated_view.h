// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <vector>

#include "core/simulation/scene.h"
#include "core/simulation/simulation_noise.h"

namespace planewright {

/// The room that emulated devices are in: what a laser sees there.
class EmulatedView {
public:
    /// `pitchAxisOffset` is d_l of Eq. (6) [m].
    EmulatedView(Scene scene, const SimulationNoise& noise, std::uint64_t seed, double pitchAxisOffset = 0.05);

    /// Where the beams of one turn look, and what the laser can see.
    struct Sweep {
        double firstPitch = 0.0;    ///< φ at the first beam [rad]
        double lastPitch = 0.0;     ///< φ at the last beam [rad], linear between
        double firstBearing = 0.0;  ///< θ of the first beam [rad]
        double bearingStep = 0.0;   ///< [rad]
        int beams = 0;
        double rangeMin = 0.0;  ///< [m]
        double rangeMax = 0.0;  ///< [m]
    };

    /// Ranges of a sweep in whole millimetres; 0 = no return. The same number draws the same errors.
    std::vector<std::uint32_t> ranges(const Sweep& sweep, int number) const;

private:
    Scene scene_;
    SimulationNoise noise_;
    std::uint64_t seed_;
    double pitchAxisOffset_;
};

}  // namespace planewright
