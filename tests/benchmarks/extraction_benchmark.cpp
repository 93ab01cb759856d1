// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <map>
#include <numeric>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include "app/process/kept_heap.h"
#include "core/evaluation/curve_fit.h"
#include "core/params/presets.h"
#include "core/pipeline/plane_extractor.h"
#include "core/simulation/nodding_scanner.h"
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
    bool explain = false;    ///< every decision is kept with its numbers, and the same is done without for comparison

    std::string name() const { return preset + "/" + scene + "/" + settings + (explain ? "/explained" : ""); }
};

/// Segments and time of all steps of each of the eight settings of Table X, by preset and scene.
std::map<std::string, std::map<int, std::pair<double, double>>> tableX;

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

/// The times of each step over the repeats of one extraction.
class StepTimes {
public:
    explicit StepTimes(std::size_t steps) : times_(steps) {}

    void add(const Run& run)
    {
        for (std::size_t i = 0; i < times_.size(); ++i)
            times_[i].push_back(run.steps[i]);
    }

    /// Median of each step [ms].
    std::vector<double> medians() const
    {
        std::vector<double> medians;
        for (const auto& times : times_)
            medians.push_back(median(times));
        return medians;
    }

    /// What a scan takes that nothing interrupts [ms]: other work on the machine stops one step of a scan at a time,
    /// and seldom the same in half of the repeats.
    double total() const
    {
        const std::vector<double> each = medians();
        return std::accumulate(each.begin(), each.end(), 0.0);
    }

private:
    std::vector<std::vector<double>> times_;
};

/// Extracts one scan again and again; a step's time is its median over the repeats, so that a hiccup of the machine is
/// not taken for a slow step.
void measure(benchmark::State& state, const Case& what)
{
    const SimulatedScan scan =
        simulate(*makeScene(what.scene, 1), *acquisitionSettings(what.settings), *simulationNoise("default"), 1);
    const Parameters parameters = parametersOf(what.preset);
    std::vector<double> totals;
    StepTimes steps(scan.recording.slices.size() + 1);
    StepTimes bareSteps(scan.recording.slices.size() + 1);
    Run run;
    for ([[maybe_unused]] const auto _ : state) {
        run = extract(scan.recording, parameters, what.explain);
        state.SetIterationTime(run.total / 1000.0);
        totals.push_back(run.total);
        steps.add(run);
        // In turn with the other, so that whatever else the machine does slows both alike.
        if (what.explain)
            bareSteps.add(extract(scan.recording, parameters, false));
    }
    const std::vector<double> medians = steps.medians();
    state.counters["median_ms"] = median(totals);
    state.counters["steps_ms"] = steps.total();
    state.counters["slowest_step_ms"] = *std::max_element(medians.begin(), medians.end());
    state.counters["last_pass_ms"] = medians.back();
    state.counters["segments"] = run.segments;
    state.counters["planes"] = run.planes;
    if (what.explain)
        state.counters["explained_ratio"] = steps.total() / bareSteps.total();
    if (what.columnOfTableX > 0)
        tableX[what.preset + " in the " + what.scene][what.columnOfTableX] = {run.segments, steps.total()};
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
    keepFreedMemory();  // as the programs do
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
    return 0;
}
