// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "tests/benchmarks/opponents/opponent.h"
#include "tests/benchmarks/scoring.h"

namespace planewright {

/// An opponent on a scan: how long it took, and how good it was with its labels completed.
struct OpponentRun {
    double milliseconds = 0.0;  ///< median over the repeats, from points in memory to planes
    Score score;
};

/// Runs an opponent some times on a scan.
OpponentRun runOpponent(const Opponent& opponent, const PointScan& scan, const Judge& judge, int repeats);

}  // namespace planewright
