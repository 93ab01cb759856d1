// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

// How many planes of simulated rooms are found, how far they are from the theoretical bound, and how long it takes.

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <numeric>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "app/cli/exit_code.h"
#include "app/cli/number_option.h"
#include "app/cli/parameter_options.h"
#include "app/cli/text.h"
#include "tests/benchmarks/room_accuracy.h"
#include "tests/benchmarks/room_details.h"
#include "tests/benchmarks/scoring.h"

using namespace planewright;

namespace {

struct Options {
    ParameterOptions parameters{"precise", {}, {}};
    std::string settings = "table8";
    std::string noise = "default";
    std::vector<std::string> scenes{"corridor", "office", "hall", "curved", "twelve", "stairs", "clutter"};
    std::int64_t minReturns = 200;
    std::uint64_t from = 1;
    std::uint64_t to = 5;
    double sigma = 0.0;  ///< [m]; 0 = as the noise profile says
    double pitch = 0.0;  ///< [°]; 0 = as the noise profile says
    bool details = false;
};

/// The options as values.
struct Setup {
    Parameters parameters;
    AcquisitionSettings settings;
    SimulationNoise noise;
};

void addOptions(CLI::App& program, Options& options)
{
    constexpr std::uint64_t kLastSeed = std::numeric_limits<std::uint64_t>::max() - 1;
    addParameterOptions(program, options.parameters);
    program.add_option("--settings", options.settings, "how the scan is taken")
        ->type_name("NAME")
        ->capture_default_str();
    program.add_option("--noise", options.noise, joined(simulationNoiseNames()))
        ->type_name("PROFILE")
        ->capture_default_str();
    program.add_option("--scenes", options.scenes, joined(sceneNames()))->type_name("NAMES")->delimiter(' ');
    addWholeNumber(program, "--min-returns", options.minReturns, std::int64_t{0},
                   std::numeric_limits<std::int64_t>::max(), "true planes of fewer returns do not count (default 200)");
    addWholeNumber(program, "--from", options.from, std::uint64_t{0}, kLastSeed, "first seed (default 1)");
    addWholeNumber(program, "--to", options.to, std::uint64_t{0}, kLastSeed, "last seed (default 5)");
    addNumber(program, "--sigma", options.sigma, 0.0, 1.0, "constant range noise in metres (default: the profile's)");
    addNumber(program, "--pitch", options.pitch, 0.0, 5.0, "pitch noise in degrees (default: the profile's)");
    program.add_flag("-v", options.details, "what was missed, is false or far off");
}

Result<Setup> setupOf(const Options& options)
{
    const auto parameters = parametersInForce(options.parameters, {});
    if (!parameters)
        return tl::unexpected{parameters.error()};
    const auto settings = acquisitionSettings(options.settings);
    if (!settings)
        return tl::unexpected{settings.error()};
    auto noise = simulationNoise(options.noise);
    if (!noise)
        return tl::unexpected{noise.error()};
    if (options.sigma > 0)
        noise->rangeConstant = options.sigma;
    if (options.pitch > 0)
        noise->pitch = degrees(options.pitch);
    return Setup{*parameters, *settings, *noise};
}

/// Sums over rooms.
struct Tally {
    MatchCounts at50, at80;
    std::vector<double> bound;  ///< e'Fe of each plane found
    std::vector<double> own;    ///< e'C⁻¹e
    std::vector<double> times;  ///< of each room [ms]

    void add(const RoomAccuracy& room)
    {
        at50 += countsOf(room.at50);
        at80 += countsOf(room.at80);
        for (const PlaneDeviation& deviation : room.deviations) {
            bound.push_back(deviation.bound);
            own.push_back(deviation.own);
        }
        times.push_back(room.milliseconds);
    }
    double meanTime() const
    {
        return std::accumulate(times.begin(), times.end(), 0.0) / std::max(1.0, static_cast<double>(times.size()));
    }
};

void printHeading()
{
    std::printf("%-10s %7s %7s %7s %7s %7s %7s %8s\n", "scene", "rec50", "prec50", "F1@50", "F1@80", "xbound", "NEES",
                "ms");
}

void printLine(const std::string& name, const Tally& tally, double time, const char* ending)
{
    std::printf("%-10s %7.3f %7.3f %7.3f %7.3f %7.2f %7.2f %8.3f%s\n", name.c_str(), tally.at50.recall(),
                tally.at50.precision(), tally.at50.f1(), tally.at80.f1(), errorOverBound(tally.bound),
                median(tally.own), time, ending);
    std::fflush(stdout);
}

Result<void> report(const Options& options)
{
    const Result<Setup> setup = setupOf(options);
    if (!setup)
        return tl::unexpected{setup.error()};
    printHeading();
    Tally all;
    for (const std::string& name : options.scenes) {
        Tally tally;
        for (std::uint64_t seed = options.from; seed <= options.to; ++seed) {
            const Result<Scene> scene = makeScene(name, seed);
            if (!scene)
                return tl::unexpected{scene.error()};
            const Room room{name, seed, *scene, setup->noise, simulate(*scene, setup->settings, setup->noise, seed)};
            const RoomAccuracy accuracy = measure(room, setup->parameters, options.minReturns);
            if (options.details)
                printDetails(room, accuracy);
            tally.add(accuracy);
            all.add(accuracy);
        }
        printLine(name, tally, median(tally.times), "");
    }
    printLine("all", all, all.meanTime(), " (mean)");
    return {};
}

}  // namespace

int main(int argc, char** argv)
{
    CLI::App program{"How many planes of simulated rooms are found, and how far they are from the theoretical bound",
                     "accuracy_report"};
    Options options;
    addOptions(program, options);
    CLI11_PARSE(program, argc, argv);
    const Result<void> done = report(options);
    if (done)
        return static_cast<int>(ExitCode::Done);
    std::fprintf(stderr, "accuracy_report: %s\n", done.error().message.c_str());
    return static_cast<int>(exitCodeOf(done.error().code));
}
