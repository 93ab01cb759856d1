// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "core/simulation/acquisition_settings.h"
#include "core/simulation/nodding_scanner.h"
#include "core/simulation/simulation_noise.h"
#include "core/types/error.h"

namespace planewright {

/// What the command line says of a simulation.
struct SimulateOptions {
    std::string scene;
    std::string output, truth, truthLabels;
    std::uint64_t seed = 1;
    std::string noise = "default";
    double dropout = -1.0;  ///< the profile's
    std::string tilt, bearing;
    int slices = 0;  ///< as --tilt says
    int floors = 0;  ///< of a building; 0: four
    int stops = 0;   ///< in a building; 0: as many as fit
    std::string truthPoses;
    bool overwrite = false;
};

/// How the scanner scans. Errors: Usage.
Result<AcquisitionSettings> settingsOf(const SimulateOptions& options);

/// What the scanner does wrong. Errors: Usage.
Result<SimulationNoise> noiseOf(const SimulateOptions& options);

/// A scan of a scene; `onSlice` hears of how many slices there are.
SimulatedScan simulatedScan(const Scene& scene, const AcquisitionSettings& settings, const SimulationNoise& noise,
                            std::uint64_t seed, const std::function<void(int slices)>& onSlice);

}  // namespace planewright
