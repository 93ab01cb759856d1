// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tests/benchmarks/paper/experiment_plan.h"

namespace planewright {

ExperimentPlan quickPlan()
{
    ExperimentPlan plan;
    plan.settings = "table10-1";
    plan.scenes = {"corridor", "twelve"};
    plan.indoor = {"corridor", "office"};
    plan.seeds = 1;
    plan.tableXColumns = 3;
    plan.productRepeats = 1;
    plan.opponentRepeats = 1;
    plan.variations = false;
    return plan;
}

PlannedScan scanOf(const std::string& scene, const std::string& settings, const SimulationNoise& noise,
                   std::uint64_t seed)
{
    PlannedScan planned{*makeScene(scene, seed), {}};
    planned.scan = simulate(planned.scene, *acquisitionSettings(settings), noise, seed);
    return planned;
}

std::size_t pointsOf(const Recording& recording)
{
    std::size_t points = 0;
    for (const ScanSlice& slice : recording.slices)
        points += slice.ranges.size();
    return points;
}

}  // namespace planewright
