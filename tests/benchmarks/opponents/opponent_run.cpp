// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tests/benchmarks/opponents/opponent_run.h"

#include <chrono>

#include "tests/benchmarks/opponents/labelled_points.h"

namespace planewright {

OpponentRun runOpponent(const Opponent& opponent, const PointScan& scan, const Judge& judge, int repeats)
{
    using Clock = std::chrono::steady_clock;
    OpponentRun run;
    OpponentResult result;
    std::vector<double> times;
    for (int repeat = 0; repeat < repeats; ++repeat) {
        const auto start = Clock::now();
        result = opponent.extract(scan);
        times.push_back(std::chrono::duration<double, std::milli>(Clock::now() - start).count());
    }
    run.milliseconds = median(times);

    completeLabels(scan, result);
    LabelGrid labels(static_cast<std::size_t>(scan.slices), std::vector<int>(static_cast<std::size_t>(scan.beams), -1));
    for (std::size_t i = 0; i < scan.points.size(); ++i)
        labels[static_cast<std::size_t>(scan.slice[i])][static_cast<std::size_t>(scan.beam[i])] = result.labels[i];
    std::vector<ComparedPlane> planes;
    for (const OpponentPlane& plane : result.planes)
        planes.push_back({static_cast<int>(planes.size()), plane.normal, plane.distance});
    run.score = judge.judge(labels, planes);
    return run;
}

}  // namespace planewright
