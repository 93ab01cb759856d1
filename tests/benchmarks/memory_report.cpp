// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

// How much memory an extraction takes beside its recording, and how often it asks for some.

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <numeric>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "core/params/presets.h"
#include "core/pipeline/plane_extractor.h"
#include "core/simulation/nodding_scanner.h"
#include "tests/benchmarks/heap.h"
#include "tests/benchmarks/scoring.h"

using namespace planewright;

namespace {

struct Options {
    std::vector<std::string> presets{"precise", "paper"};
    std::string settings = "largest";
    std::vector<std::string> scenes{"corridor", "office", "hall", "curved", "stairs", "clutter"};
};

/// What one extraction asked of the heap.
struct Usage {
    double most = 0.0;             ///< at any time beside the recording [MB]
    double kept = 0.0;             ///< after the last pass [MB]
    std::vector<double> requests;  ///< of each slice
    std::size_t segments = 0;
    std::size_t planes = 0;
};

/// With a snapshot of each step the newest is held, as a window does.
Usage usageOf(const Recording& recording, const Parameters& parameters, bool snapshots)
{
    constexpr double kMegabyte = 1e6;
    Usage usage;
    usage.requests.reserve(recording.slices.size());
    const Heap before = heap;
    heap.most = heap.held;
    PlaneExtractor extractor(sensorOf(recording.description), parameters);
    std::shared_ptr<const Snapshot> newest;
    for (const ScanSlice& slice : recording.slices) {
        const std::int64_t asked = heap.requests;
        if (snapshots)
            newest = extractor.step(slice);
        else
            extractor.advance(slice);
        usage.requests.push_back(static_cast<double>(heap.requests - asked));
    }
    newest = extractor.finish();
    usage.most = static_cast<double>(heap.most - before.held) / kMegabyte;
    usage.kept = static_cast<double>(heap.held - before.held) / kMegabyte;
    usage.segments = newest->segments.segmentCount();
    usage.planes = newest->planes.size();
    return usage;
}

/// The slices after those in which working storage gets its size.
std::vector<double> steadyState(const std::vector<double>& requests)
{
    constexpr std::size_t kFirstSlices = 8;
    return {requests.begin() + static_cast<std::ptrdiff_t>(std::min(kFirstSlices, requests.size() - 1)),
            requests.end()};
}

Result<void> reportPreset(const Options& options, const std::string& presetName, const AcquisitionSettings& settings)
{
    const Preset* preset = findPreset(methodPresets(), presetName);
    if (preset == nullptr)
        return fail(ErrorCode::Usage, "No preset is called '" + presetName + "'.");
    Parameters parameters;
    apply(*preset, parameters);
    std::printf(
        "%s, %s\n\n| scene | segments | planes | most [MB] | kept [MB] | most, with snapshots [MB] | requests a "
        "slice, mean | median | most | slices that ask |\n"
        "| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n",
        presetName.c_str(), options.settings.c_str());
    for (const std::string& name : options.scenes) {
        const auto scene = makeScene(name, 1);
        if (!scene)
            return tl::unexpected{scene.error()};
        const SimulatedScan scan = simulate(*scene, settings, *simulationNoise("default"), 1);
        const Usage bare = usageOf(scan.recording, parameters, false);
        const Usage shown = usageOf(scan.recording, parameters, true);
        const std::vector<double> steady = steadyState(bare.requests);
        const auto count = static_cast<double>(steady.size());
        const auto asks = std::count_if(steady.begin(), steady.end(), [](double n) { return n > 0.0; });
        std::printf("| %s | %zu | %zu | %.2f | %.2f | %.2f | %.1f | %.0f | %.0f | %.0f %% |\n", name.c_str(),
                    bare.segments, bare.planes, bare.most, bare.kept, shown.most,
                    std::accumulate(steady.begin(), steady.end(), 0.0) / count, median(steady),
                    *std::max_element(steady.begin(), steady.end()), 100.0 * static_cast<double>(asks) / count);
        std::fflush(stdout);
    }
    std::printf("\n");
    return {};
}

Result<void> report(const Options& options)
{
    const auto settings = acquisitionSettings(options.settings);
    if (!settings)
        return tl::unexpected{settings.error()};
    for (const std::string& preset : options.presets) {
        if (const auto done = reportPreset(options, preset, *settings); !done)
            return done;
    }
    return {};
}

}  // namespace

int main(int argc, char** argv)
{
    CLI::App program{"How much memory an extraction takes beside its recording, and how often it asks for some",
                     "memory_report"};
    Options options;
    program.add_option("--preset", options.presets, "presets of the method")->capture_default_str();
    program.add_option("--settings", options.settings, "how the scan is taken")->capture_default_str();
    program.add_option("--scenes", options.scenes, "rooms");
    CLI11_PARSE(program, argc, argv);
    const Result<void> done = report(options);
    if (done)
        return 0;
    std::fprintf(stderr, "memory_report: %s\n", done.error().message.c_str());
    return 1;
}
