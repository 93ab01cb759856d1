// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/simulation/nodding_scanner.h"

namespace planewright {

/// How much of everything a report has: the same code runs for a smoke and for the full volume.
struct ExperimentPlan {
    std::string settings = "table8";  ///< acquisition of the scans that are not those of Table X
    std::vector<std::string> scenes{"corridor", "office", "hall", "curved", "twelve", "stairs", "clutter"};
    std::vector<std::string> indoor{"corridor", "curved", "office", "hall"};  ///< stand in for the four of Table IX
    int seeds = 5;                                                            ///< from 1 on
    int tableXColumns = 8;
    int productRepeats = 9;
    int opponentRepeats = 3;
    bool variations = true;  ///< also with more noise, fewer points and more points
};

/// The smoke: seconds.
ExperimentPlan quickPlan();

/// One simulated scan of a scene, and the scene.
struct PlannedScan {
    Scene scene;
    SimulatedScan scan;
};
PlannedScan scanOf(const std::string& scene, const std::string& settings, const SimulationNoise& noise,
                   std::uint64_t seed);

/// Beams of a scan, with or without return: the paper's number of scan points.
std::size_t pointsOf(const Recording& recording);

}  // namespace planewright
