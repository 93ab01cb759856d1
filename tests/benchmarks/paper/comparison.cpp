// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tests/benchmarks/paper/comparison.h"

#include <algorithm>
#include <cstdio>

#include "tests/benchmarks/opponents/opponent_run.h"
#include "tests/benchmarks/opponents/opponents.h"
#include "tests/benchmarks/paper/product_run.h"

namespace planewright {

std::vector<std::string> methodNames()
{
    std::vector<std::string> names(kPresets.begin(), kPresets.end());
    for (const auto& opponent : makeOpponents())
        names.emplace_back(opponent->name());
    return names;
}

std::vector<ComparedScan> compareMethods(const ExperimentPlan& plan, const ComparisonCase& what)
{
    const auto opponents = makeOpponents();
    std::vector<ComparedScan> scans;
    for (const std::string& name : plan.scenes) {
        for (int seed = 1; seed <= plan.seeds; ++seed) {
            std::fprintf(stderr, "%s: %s %d\n", what.title.c_str(), name.c_str(), seed);
            ComparedScan compared{name, static_cast<std::uint64_t>(seed), 0, {}};
            const PlannedScan planned = scanOf(name, what.settings, what.noise, compared.seed);
            const Judge judge(planned.scene, planned.scan, what.noise, what.minReturns);
            compared.points = pointsOf(planned.scan.recording);
            for (const std::string_view preset : kPresets) {
                const Parameters parameters = presetParameters(preset);
                const ProductRun run = runProduct(planned.scan.recording, parameters, plan.productRepeats);
                compared.methods.push_back(
                    {run.milliseconds, segmentsOf(run), judged(run, planned.scan.recording, parameters, judge)});
            }
            const PointScan points = pointScanOf(planned.scan.recording, what.noise);
            for (const auto& opponent : opponents) {
                const OpponentRun run = runOpponent(*opponent, points, judge, plan.opponentRepeats);
                compared.methods.push_back({run.milliseconds, 0.0, run.score});
            }
            scans.push_back(std::move(compared));
        }
    }
    return scans;
}

Score total(const std::vector<ComparedScan>& scans, std::size_t method)
{
    Score sum;
    for (const ComparedScan& scan : scans) {
        const Score& score = scan.methods[method].score;
        sum.at50 += score.at50;
        sum.at80 += score.at80;
        sum.found.insert(sum.found.end(), score.found.begin(), score.found.end());
    }
    return sum;
}

double meanTime(const std::vector<ComparedScan>& scans, std::size_t method)
{
    double sum = 0.0;
    for (const ComparedScan& scan : scans)
        sum += scan.methods[method].milliseconds / static_cast<double>(scans.size());
    return sum;
}

std::vector<FoundByBoth> foundByBoth(const std::vector<ComparedScan>& scans, std::size_t first, std::size_t second)
{
    std::vector<FoundByBoth> both;
    for (const ComparedScan& scan : scans) {
        const std::vector<FoundPlane>& others = scan.methods[second].score.found;
        for (const FoundPlane& plane : scan.methods[first].score.found) {
            const auto other =
                std::find_if(others.begin(), others.end(), [&](const FoundPlane& p) { return p.truth == plane.truth; });
            if (other != others.end())
                both.push_back({plane, *other});
        }
    }
    return both;
}

}  // namespace planewright
