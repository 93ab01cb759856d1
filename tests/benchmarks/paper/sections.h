// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include "tests/benchmarks/paper/comparison.h"
#include "tests/benchmarks/paper/experiment_plan.h"
#include "tests/benchmarks/paper/report.h"

namespace planewright {

// The parts of the report, in the order of the paper's section 5. Those that need the comparison of all extractors at
// the plan's settings and with default noise take its scans.

/// Fig. 5: clusters of a side wall's segments by the three moving averages.
void writeClustering(Report& report, const ExperimentPlan& plan);

/// Table IX and Fig. 14: what four rooms give, and time against segments at the same number of points.
void writeIndoor(Report& report, const ExperimentPlan& plan, const std::vector<ComparedScan>& scans);

/// Fig. 15, 17 and 18: one scan step by step.
void writeSteps(Report& report, const ExperimentPlan& plan);

/// Table X and Fig. 16: time against points and segments of one room.
void writeGrowth(Report& report, const ExperimentPlan& plan);

/// Tables XII and XIII: errors on the twelve planes.
void writeTwelvePlanes(Report& report, const ExperimentPlan& plan, const std::vector<ComparedScan>& scans);

/// Fig. 20, accuracy and speed against every opponent.
void writeOpponents(Report& report, const ExperimentPlan& plan, const std::vector<ComparedScan>& scans);

/// The same figures with more noise, fewer points and more points.
void writeVariations(Report& report, const ExperimentPlan& plan);

}  // namespace planewright
