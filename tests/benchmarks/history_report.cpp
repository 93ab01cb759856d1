// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

// How much memory the history of a scan takes, and how long it takes to see how one of its steps went.

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "core/params/presets.h"
#include "core/pipeline/plane_lives.h"
#include "core/pipeline/step_replay.h"
#include "core/simulation/nodding_scanner.h"
#include "tests/benchmarks/heap.h"

using namespace planewright;

namespace {

using SteadyClock = std::chrono::steady_clock;
using Milliseconds = std::chrono::duration<double, std::milli>;
using SharedSlices = std::vector<std::shared_ptr<const ScanSlice>>;

struct Options {
    std::vector<std::string> presets{"precise", "paper"};
    std::string settings = "largest";
    std::vector<std::string> scenes{"corridor", "office", "hall", "curved", "stairs", "clutter"};
    int steps = 0;
    int jumps = 200;
};

double since(SteadyClock::time_point start)
{
    return Milliseconds(SteadyClock::now() - start).count();
}

double megabytes(std::int64_t bytes)
{
    return static_cast<double>(bytes) * 1e-6;
}

/// The value that so large a share of all does not exceed.
double percentile(std::vector<double> values, double share)
{
    std::sort(values.begin(), values.end());
    const auto last = static_cast<double>(values.size() - 1);
    return values[static_cast<std::size_t>(std::ceil(share * last))];
}

struct Kept {
    double slices = 0.0;     ///< of the recording [MB]
    double snapshots = 0.0;  ///< of all steps [MB]
    double explained = 0.0;  ///< the same with every decision [MB]
    double replay = 0.0;     ///< what going back to steps adds at most [MB]
};

struct Measured {
    Kept kept;
    std::vector<double> jumps;    ///< to any step [ms]
    std::vector<double> forward;  ///< to the next one [ms]
    double lineage = 0.0;         ///< of the whole scan, reports and all [ms]
    double silent = 0.0;          ///< extraction with all its snapshots [ms]
    double explained = 0.0;       ///< the same with every decision [ms]
};

/// Every snapshot of a scan.
std::vector<std::shared_ptr<const Snapshot>> historyOf(const Recording& recording, const Parameters& parameters,
                                                       bool explain)
{
    std::vector<std::shared_ptr<const Snapshot>> history;
    PlaneExtractor extractor(sensorOf(recording.description), parameters, {{}, explain});
    for (const ScanSlice& slice : recording.slices)
        history.push_back(extractor.step(slice));
    history.push_back(extractor.finish());
    return history;
}

double historySize(const Recording& recording, const Parameters& parameters, bool explain)
{
    const std::int64_t before = heap.held;
    const auto history = historyOf(recording, parameters, explain);
    return megabytes(heap.held - before);
}

double timeOf(const Recording& recording, const Parameters& parameters, bool explain)
{
    constexpr int kRepeats = 5;
    std::vector<double> times;
    for (int i = 0; i < kRepeats; ++i) {
        const auto start = SteadyClock::now();
        const auto history = historyOf(recording, parameters, explain);
        times.push_back(since(start));
    }
    return percentile(times, 0.5);
}

Measured measure(const Recording& recording, const Parameters& parameters, int jumps)
{
    Measured measured;
    const std::int64_t before = heap.held;
    SharedSlices slices;
    for (const ScanSlice& slice : recording.slices)
        slices.push_back(std::make_shared<const ScanSlice>(slice));
    measured.kept.slices = megabytes(heap.held - before);
    measured.kept.snapshots = historySize(recording, parameters, false);
    measured.kept.explained = historySize(recording, parameters, true);
    measured.silent = timeOf(recording, parameters, false);
    measured.explained = timeOf(recording, parameters, true);

    const auto steps = static_cast<int>(slices.size());
    StepReplay replay(sensorOf(recording.description), parameters);
    for (const auto& slice : slices)
        replay.add(slice);
    const std::int64_t bare = heap.held;
    heap.most = heap.held;
    const auto go = [&](int step) {
        const auto start = SteadyClock::now();
        const auto went = replay.at(step);
        const double time = since(start);
        if (!went || (*went)->phases.empty())
            std::abort();
        return time;
    };
    std::mt19937 random(1);
    for (int i = 0; i < jumps; ++i)
        measured.jumps.push_back(go(static_cast<int>(random() % static_cast<unsigned>(steps))));
    for (int step = 0; step < steps; ++step)
        measured.forward.push_back(go(step));
    go(kLastPass);
    measured.kept.replay = megabytes(heap.most - bare);

    const auto start = SteadyClock::now();
    PlaneLives lives;
    replay.visit(true, [&](const Snapshot& snapshot) { lives.add(snapshot); });
    measured.lineage = since(start);
    return measured;
}

Result<void> reportPreset(const Options& options, const std::string& presetName, const AcquisitionSettings& settings)
{
    const Preset* preset = findPreset(methodPresets(), presetName);
    if (preset == nullptr)
        return fail(ErrorCode::Usage, "No preset is called '" + presetName + "'.");
    Parameters parameters;
    apply(*preset, parameters);
    std::printf(
        "%s, %d steps of %d beams\n\n"
        "| scene | slices [MB] | snapshots [MB] | with decisions [MB] | replay [MB] | jump p50 [ms] | p95 | most "
        "| next p95 [ms] | extraction [ms] | with decisions | lineage [ms] |\n"
        "| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n",
        presetName.c_str(), settings.slices, settings.beams);
    for (const std::string& name : options.scenes) {
        const auto scene = makeScene(name, 1);
        if (!scene)
            return tl::unexpected{scene.error()};
        const SimulatedScan scan = simulate(*scene, settings, *simulationNoise("default"), 1);
        const Measured m = measure(scan.recording, parameters, options.jumps);
        std::printf("| %s | %.1f | %.1f | %.1f | %.1f | %.1f | %.1f | %.1f | %.2f | %.1f | %.1f | %.1f |\n",
                    name.c_str(), m.kept.slices, m.kept.snapshots, m.kept.explained, m.kept.replay,
                    percentile(m.jumps, 0.5), percentile(m.jumps, 0.95), percentile(m.jumps, 1.0),
                    percentile(m.forward, 0.95), m.silent, m.explained, m.lineage);
        std::fflush(stdout);
    }
    std::printf("\n");
    return {};
}

Result<void> report(const Options& options)
{
    auto settings = acquisitionSettings(options.settings);
    if (!settings)
        return tl::unexpected{settings.error()};
    if (options.steps > 0) {
        // The same sweep in so many steps.
        settings->tiltStep *= static_cast<double>(settings->slices - 1) / std::max(1, options.steps - 1);
        settings->slices = options.steps;
    }
    for (const std::string& preset : options.presets) {
        if (const auto done = reportPreset(options, preset, *settings); !done)
            return done;
    }
    return {};
}

}  // namespace

int main(int argc, char** argv)
{
    CLI::App program{"How much memory the history of a scan takes, and how long it takes to see how a step went",
                     "history_report"};
    Options options;
    program.add_option("--preset", options.presets, "presets of the method")->capture_default_str();
    program.add_option("--settings", options.settings, "how the scan is taken")->capture_default_str();
    program.add_option("--steps", options.steps, "the same sweep in so many steps; 0 as the settings say")
        ->capture_default_str()
        ->check(CLI::Range(0, 65'536));
    program.add_option("--jumps", options.jumps, "to steps at random")
        ->capture_default_str()
        ->check(CLI::Range(1, 100'000));
    program.add_option("--scenes", options.scenes, "rooms");
    CLI11_PARSE(program, argc, argv);
    const Result<void> done = report(options);
    if (done)
        return 0;
    std::fprintf(stderr, "history_report: %s\n", done.error().message.c_str());
    return 1;
}
