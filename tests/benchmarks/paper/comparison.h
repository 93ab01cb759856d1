// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tests/benchmarks/paper/experiment_plan.h"
#include "tests/benchmarks/scoring.h"

namespace planewright {

/// All extractors by name, `paper` and `precise` first, then the opponents.
std::vector<std::string> methodNames();

/// One extractor on one scan.
struct MethodOnScan {
    double milliseconds = 0.0;
    double segments = 0.0;  ///< line segments, of the product only
    Score score;
};

/// All extractors on one scan, one after the other in the same process, in the order of methodNames().
struct ComparedScan {
    std::string scene;
    std::uint64_t seed = 0;
    std::size_t points = 0;
    std::vector<MethodOnScan> methods;
};

/// What a comparison varies.
struct ComparisonCase {
    std::string title;
    std::string settings;
    SimulationNoise noise;
    std::int64_t minReturns = 200;  ///< smaller true planes count neither for nor against anyone
};

std::vector<ComparedScan> compareMethods(const ExperimentPlan& plan, const ComparisonCase& what);

/// Counts and found planes of one method over scans.
Score total(const std::vector<ComparedScan>& scans, std::size_t method);

/// Mean time of one method over scans [ms].
double meanTime(const std::vector<ComparedScan>& scans, std::size_t method);

/// The same true plane as two methods found it.
struct FoundByBoth {
    FoundPlane first;
    FoundPlane second;
};
std::vector<FoundByBoth> foundByBoth(const std::vector<ComparedScan>& scans, std::size_t first, std::size_t second);

}  // namespace planewright
