// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <string>

#include "core/simulation/acquisition_settings.h"
#include "core/simulation/simulation_noise.h"
#include "core/types/error.h"
#include "ui/common/device_setup.h"

namespace planewright {

/// A simulated scan as it is set up in the window. Angles are degrees, as they are typed.
struct SimulationSetup {
    std::string scene = "corridor";
    std::uint64_t seed = 1;
    std::string noise = "default";  ///< name of a profile
    double firstTilt = 10.0;        ///< [degrees]
    double lastTilt = 170.0;        ///< where the scan ends, no slice of its own [degrees]
    double tiltStep = 1.16;         ///< [degrees]
    double firstBearing = 0.0;      ///< [degrees]
    double lastBearing = 180.0;     ///< of the last beam [degrees]
    double bearingStep = 0.25;      ///< [degrees]
    double speed = 1.0;             ///< 1 is real time, 0 as fast as possible

    friend bool operator==(const SimulationSetup&, const SimulationSetup&) = default;
};

/// How the simulated scanner takes its scan. Errors (Usage) are sentences that say what to give instead.
Result<AcquisitionSettings> acquisitionOf(const SimulationSetup& setup);

/// The same of a scan with devices, which has the laser's own resolution: 0.25° here. Stepping takes three turns of the
/// mirror for each slice, about.
Result<AcquisitionSettings> acquisitionOf(const DeviceSetup& setup);

/// `sim:SCENE?seed=N&speed=X`: what an address says of it.
std::string addressOf(const SimulationSetup& setup);

/// "137 steps × 721 points = 98,777 points, about 3.4 s", at the scanner's own speed.
std::string scanSizeText(const AcquisitionSettings& settings);

}  // namespace planewright
