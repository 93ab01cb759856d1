// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

// How far the planes of real recordings move when every second slice is taken away, in units of what their covariances
// say: whether these are honest where no truth is known.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "app/cli/exit_code.h"
#include "app/cli/number_option.h"
#include "app/cli/parameter_options.h"
#include "app/cli/recording_file.h"
#include "core/types/angle.h"
#include "tests/benchmarks/refitted_planes.h"
#include "tests/benchmarks/repeated_planes.h"
#include "tests/benchmarks/scoring.h"

using namespace planewright;

namespace {

struct Options {
    ParameterOptions parameters{"precise", {}, {}};
    std::vector<std::string> recordings{PLANEWRIGHT_SAMPLES "/lobby.csv.gz", PLANEWRIGHT_SAMPLES "/desk.csv.gz"};
    int minPoints = 200;
    double overlap = 0.8;
    bool planes = false;
};

/// Chi-square of three degrees of freedom is larger once in a hundred times.
constexpr double kSeldomLarger = 11.345;
/// Planes of so many points are known so well that little else than noise can hide.
constexpr int kManyPoints = 1000;

/// A comparison of two estimates of a recording's planes.
struct Comparison {
    const char* name;
    std::vector<RepeatedPlane> planes;
    int withoutCovariance = 0;
};

Comparison comparisonOf(const char* name, Repetition repetition)
{
    return {name, std::move(repetition.planes), repetition.withoutCovariance};
}

void printPlanes(const std::vector<RepeatedPlane>& planes)
{
    if (planes.empty())
        return;
    std::printf(
        "\n| even slices | odd slices | points | angle [deg] | its sigma | distance [mm] | its sigma | squared "
        "|\n| --- | --- | --- | --- | --- | --- | --- | --- |\n");
    for (const RepeatedPlane& plane : planes)
        std::printf("| %d | %d | %d | %.3f | %.3f | %.2f | %.2f | %.2f |\n", plane.first->id, plane.second->id,
                    plane.first->points + plane.second->points, toDegrees(plane.angle()), toDegrees(plane.angleSigma()),
                    1000.0 * std::abs(plane.moved[2]), 1000.0 * std::sqrt(plane.covariance(2, 2)), plane.squared);
}

void printRow(const std::string& recording, const Comparison& comparison, int minPoints)
{
    std::vector<double> angles;
    std::vector<double> distances;
    std::vector<double> squares;
    for (const RepeatedPlane& plane : comparison.planes) {
        // Of half against all, the points of all are those of both halves.
        if (std::max(plane.first->points + plane.second->points, plane.first->points * 2) < minPoints)
            continue;
        angles.push_back(toDegrees(plane.angle()));
        distances.push_back(1000.0 * std::abs(plane.moved[2]));
        squares.push_back(plane.squared);
    }
    if (squares.empty())
        return;
    const double sum = std::accumulate(squares.begin(), squares.end(), 0.0);
    const auto larger = std::count_if(squares.begin(), squares.end(), [](double s) { return s > kSeldomLarger; });
    std::printf("| %s | %s | %s | %zu | %.3f | %.2f | %.2f | %.2f | %td |\n", recording.c_str(), comparison.name,
                minPoints >= kManyPoints ? "1000" : "all", squares.size(), median(angles), median(distances),
                median(squares), sum / static_cast<double>(squares.size()), larger);
}

void printSummary(const std::string& recording, const std::vector<Comparison>& comparisons)
{
    for (const Comparison& comparison : comparisons) {
        printRow(recording, comparison, 0);
        printRow(recording, comparison, kManyPoints);
    }
}

void printLeftOut(const std::string& recording, const std::vector<Comparison>& comparisons)
{
    for (const Comparison& comparison : comparisons) {
        if (comparison.withoutCovariance > 0)
            std::printf("%s, %s: %d pairs left out, whose difference has no positive covariance.\n", recording.c_str(),
                        comparison.name, comparison.withoutCovariance);
    }
}

Result<void> report(const Options& options)
{
    std::vector<std::pair<std::string, std::vector<Comparison>>> all;
    for (const std::string& path : options.recordings) {
        const auto read = readRecordingFile(path);
        if (!read)
            return tl::unexpected{read.error()};
        const auto parameters = parametersInForce(options.parameters, read->recording.description.scanner);
        if (!parameters)
            return tl::unexpected{parameters.error()};
        const Extracted whole = extractFrom(read->recording, Slices::All, *parameters);
        const Extracted even = extractFrom(read->recording, Slices::Even, *parameters);
        const Extracted odd = extractFrom(read->recording, Slices::Odd, *parameters);
        const SensorNoise& noise = whole.found->noise;
        const std::string name = path.substr(path.find_last_of('/') + 1);
        std::printf(
            "\n%s: %zu slices, %zu planes of all, %zu of the even, %zu of the odd; range noise %.1f mm and "
            "%.2f mm per metre, pitch %.3f deg\n",
            name.c_str(), read->recording.slices.size(), whole.found->planes.size(), even.found->planes.size(),
            odd.found->planes.size(), 1000.0 * noise.rangeConstant, 1000.0 * noise.rangeProportional,
            toDegrees(noise.pitch));
        std::vector<Comparison> comparisons{
            {"same segments, even and odd", refittedPlanes(whole, *parameters, options.minPoints)},
            comparisonOf("even and odd slices",
                         repeatedPlanes(even, odd, Share::Nothing, options.overlap, options.minPoints / 2)),
            comparisonOf("even slices and all",
                         repeatedPlanes(even, whole, Share::Half, options.overlap, options.minPoints / 2)),
            comparisonOf("odd slices and all",
                         repeatedPlanes(odd, whole, Share::Half, options.overlap, options.minPoints / 2))};
        if (options.planes) {
            printPlanes(comparisons[0].planes);
            printPlanes(comparisons[1].planes);
        }
        all.emplace_back(name, std::move(comparisons));
    }
    std::printf(
        "\n| recording | compared | points from | planes | angle, median [deg] | distance, median [mm] | squared, "
        "median | squared, mean | over 11.3 |\n| --- | --- | --- | --- | --- | --- | --- | --- | --- |\n");
    for (const auto& [name, comparisons] : all)
        printSummary(name, comparisons);
    std::printf("\n");
    for (const auto& [name, comparisons] : all)
        printLeftOut(name, comparisons);
    std::printf(
        "\nSquared: how far a plane moved, squared and over its variance; 2.37 is the median, 3 the mean and "
        "one in a hundred over 11.3 where covariances are honest.\n");
    return {};
}

}  // namespace

int main(int argc, char** argv)
{
    CLI::App program{
        "How far planes of real recordings move when every second slice is taken away, in units of what "
        "their covariances say",
        "repeatability_report"};
    Options options;
    addParameterOptions(program, options.parameters);
    program.add_option("recordings", options.recordings, "recordings (default: the samples)");
    addWholeNumber(program, "--min-points", options.minPoints, 0, 1'000'000'000,
                   "planes with fewer points in all slices do not count (default 200)");
    addNumber(program, "--overlap", options.overlap, 0.0, 1.0,
              "share of either region that both must have in common (default 0.8)");
    program.add_flag("-v", options.planes, "a row for each plane");
    CLI11_PARSE(program, argc, argv);
    const Result<void> done = report(options);
    if (done)
        return static_cast<int>(ExitCode::Done);
    std::fprintf(stderr, "repeatability_report: %s\n", done.error().message.c_str());
    return static_cast<int>(exitCodeOf(done.error().code));
}
