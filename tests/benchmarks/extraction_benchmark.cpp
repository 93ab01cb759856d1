// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <map>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include "core/params/presets.h"
#include "core/pipeline/plane_extractor.h"
#include "core/simulation/nodding_scanner.h"
#include "tests/benchmarks/power_fit.h"
#include "tests/benchmarks/scoring.h"

using namespace planewright;

namespace {

using Milliseconds = std::chrono::duration<double, std::milli>;
using SteadyClock = std::chrono::steady_clock;

/// What is extracted how.
struct Case {
    std::string preset;
    std::string scene;
    std::string settings;
    int columnOfTableX = 0;  ///< 0 for none
    bool explain = false;    ///< every decision is kept with its numbers

    std::string name() const { return preset + "/" + scene + "/" + settings + (explain ? "/explained" : ""); }
};

/// Segments and median time of each of the eight settings of Table X, by preset and scene.
std::map<std::string, std::map<int, std::pair<double, double>>> tableX;
/// Median time of each case that was measured, by name [ms].
std::map<std::string, double> medianTimes;

struct Run {
    double total = 0.0;         ///< [ms], from slices in memory to planes
    std::vector<double> steps;  ///< [ms] each, the last pass last
    double segments = 0.0;
    double planes = 0.0;
};

Parameters parametersOf(const std::string& preset)
{
    Parameters parameters;
    apply(*findPreset(methodPresets(), preset), parameters);
    return parameters;
}

Run extract(const Recording& recording, const Parameters& parameters, bool explain)
{
    Run run;
    run.steps.reserve(recording.slices.size() + 1);
    const auto start = SteadyClock::now();
    PlaneExtractor extractor(sensorOf(recording.description), parameters, {{}, explain});
    auto before = start;
    const auto lap = [&] {
        const auto now = SteadyClock::now();
        run.steps.push_back(Milliseconds(now - before).count());
        before = now;
    };
    for (const ScanSlice& slice : recording.slices) {
        extractor.advance(slice);
        lap();
    }
    const auto found = extractor.finish();
    lap();
    run.total = Milliseconds(before - start).count();
    run.segments = static_cast<double>(found->segments.segmentCount());
    run.planes = static_cast<double>(found->planes.size());
    return run;
}

/// Extracts one scan again and again; a step's time is its median over the repeats, so that a hiccup of the machine is
/// not taken for a slow step.
void measure(benchmark::State& state, const Case& what)
{
    const SimulatedScan scan =
        simulate(*makeScene(what.scene, 1), *acquisitionSettings(what.settings), *simulationNoise("default"), 1);
    const Parameters parameters = parametersOf(what.preset);
    std::vector<double> totals;
    std::vector<std::vector<double>> steps(scan.recording.slices.size() + 1);
    Run run;
    for ([[maybe_unused]] const auto _ : state) {
        run = extract(scan.recording, parameters, what.explain);
        state.SetIterationTime(run.total / 1000.0);
        totals.push_back(run.total);
        for (std::size_t i = 0; i < steps.size(); ++i)
            steps[i].push_back(run.steps[i]);
    }
    double slowest = 0.0;
    for (const auto& times : steps)
        slowest = std::max(slowest, median(times));
    state.counters["median_ms"] = median(totals);
    state.counters["slowest_step_ms"] = slowest;
    state.counters["last_pass_ms"] = median(steps.back());
    state.counters["segments"] = run.segments;
    state.counters["planes"] = run.planes;
    medianTimes[what.name()] = median(totals);
    if (what.columnOfTableX > 0)
        tableX[what.preset + " in the " + what.scene][what.columnOfTableX] = {run.segments, median(totals)};
}

void reportGrowth(const std::string& where, const std::map<int, std::pair<double, double>>& columns)
{
    std::vector<double> segments;
    std::vector<double> times;
    for (const auto& [column, measured] : columns) {
        segments.push_back(measured.first);
        times.push_back(measured.second);
    }
    const LineFit line = lineThrough(segments, times);
    const PowerFit power = powerThrough(segments, times);
    std::printf("Table X, %s, time against segments: %.2f us a segment, R2 %.4f; exponent %.3f (log-log R2 %.4f)\n",
                where.c_str(), 1000.0 * line.slope, line.explained, power.exponent, power.explained);
}

/// How much longer a scan takes with every decision kept.
void reportExplanations()
{
    for (const auto& [name, time] : medianTimes) {
        const auto explained = medianTimes.find(name + "/explained");
        if (explained != medianTimes.end())
            std::printf("%s: explanations take %.2f times as long\n", name.c_str(), explained->second / time);
    }
}

void add(const Case& what)
{
    benchmark::RegisterBenchmark(what.name().c_str(), measure, what)
        ->UseManualTime()
        ->Unit(benchmark::kMillisecond)
        ->MinTime(0.5);
}

}  // namespace

int main(int argc, char** argv)
{
    for (const char* preset : {"paper", "precise"}) {
        for (const char* scene : {"corridor", "office", "hall"}) {
            add({preset, scene, "table8"});
            add({preset, scene, "table8", 0, true});
            add({preset, scene, "largest"});
            for (int column = 1; column <= 8; ++column)
                add({preset, scene, "table10-" + std::to_string(column), column});
        }
    }
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv))
        return 1;
    benchmark::RunSpecifiedBenchmarks();
    for (const auto& [where, columns] : tableX) {
        if (columns.size() == 8)
            reportGrowth(where, columns);
    }
    reportExplanations();
    return 0;
}
