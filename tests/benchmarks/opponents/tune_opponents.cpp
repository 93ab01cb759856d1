// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

// Tries parameters of the opponents on simulated scans whose seeds no report uses, and prints how good each setting is:
// what stands in the opponents' headers is the best of these.

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "tests/benchmarks/opponents/efficient_ransac.h"
#include "tests/benchmarks/opponents/opponent_run.h"
#include "tests/benchmarks/opponents/organized_planes.h"
#include "tests/benchmarks/opponents/prosac_normal.h"
#include "tests/benchmarks/opponents/prosac_only.h"
#include "tests/benchmarks/opponents/randomized_hough.h"
#include "tests/benchmarks/opponents/region_growing.h"

using namespace planewright;

namespace {

struct TuningScan {
    Scene scene;
    SimulatedScan scan;
    PointScan points;
    std::unique_ptr<Judge> judge;
};

/// A setting to try: what it changes, and the opponent with it.
struct Setting {
    std::string text;
    std::function<std::unique_ptr<Opponent>()> make;
};

/// One parameter and the values that are tried in its place, all others as they are.
template <class Parameters>
struct Row {
    const char* name;
    std::function<void(Parameters&, double)> set;
    std::vector<double> values;
};

template <class Type, class Parameters>
std::vector<Setting> settingsOf(const std::vector<Row<Parameters>>& rows)
{
    std::vector<Setting> settings{{"as it is", [] { return std::make_unique<Type>(); }}};
    for (const Row<Parameters>& row : rows) {
        for (const double value : row.values) {
            settings.push_back({std::string(row.name) + " " + std::to_string(value), [row, value] {
                                    Parameters parameters;
                                    row.set(parameters, value);
                                    return std::make_unique<Type>(parameters);
                                }});
        }
    }
    return settings;
}

template <class Parameters>
Row<Parameters> row(const char* name, double Parameters::*member, std::vector<double> values)
{
    return {name, [member](Parameters& p, double value) { p.*member = value; }, std::move(values)};
}

template <class Parameters>
Row<Parameters> row(const char* name, int Parameters::*member, std::vector<double> values)
{
    return {name, [member](Parameters& p, double value) { p.*member = static_cast<int>(value); }, std::move(values)};
}

template <class Parameters>
Row<Parameters> voxel(std::vector<double> values)
{
    return {"voxel", [](Parameters& p, double value) { p.reduction = {value, 0.0}; }, std::move(values)};
}

template <class Parameters>
Row<Parameters> bearing()
{
    return {"bearing",
            [](Parameters& p, double value) { p.reduction.bearing = degrees(value); },
            {0.5, 0.75, 1.0, 1.5, 2.0}};
}

template <class Parameters>
Row<Parameters> support(std::vector<double> values)
{
    return {"support", [](Parameters& p, double value) { p.finish.support = value; }, std::move(values)};
}

template <class Parameters>
Row<Parameters> mergeAngle()
{
    return {"merge-angle", [](Parameters& p, double value) { p.finish.mergeAngle = value; }, {0.03, 0.06, 0.15}};
}

template <class Parameters>
Row<Parameters> mergeSigmas()
{
    return {"merge-sigmas", [](Parameters& p, double value) { p.finish.mergeSigmas = value; }, {0.0, 1.0, 1.5, 3.0}};
}

std::vector<Setting> settingsFor(const std::string& opponent)
{
    if (opponent == "prosac-only") {
        using P = ProsacOnlyParameters;
        return settingsOf<ProsacOnly, P>({voxel<P>({2.5, 3.5, 4.75, 7.0, 12.0}), bearing<P>(),
                                          row("tolerance", &P::toleranceSigmas, {1.5, 2.0, 2.5, 4.0}),
                                          row("iterations", &P::iterations, {100, 300, 2000}),
                                          support<P>({1.5, 2.0, 3.0, 5.0}), mergeAngle<P>(), mergeSigmas<P>()});
    }
    if (opponent == "prosac-normal") {
        using P = ProsacNormalParameters;
        return settingsOf<ProsacNormal, P>(
            {voxel<P>({2.5, 3.5, 4.75, 7.0, 12.0}), bearing<P>(), row("neighbours", &P::neighbours, {10, 24, 40, 60}),
             row("angle", &P::clusterAngle, {0.2, 0.25, 0.5}), row("gap", &P::gap, {0.0, 1.5, 2.0, 3.0, 5.0, 8.0}),
             row("tolerance", &P::toleranceSigmas, {1.5, 2.0, 4.0}),
             row("iterations", &P::iterations, {100, 200, 1000}), support<P>({0.7, 1.5, 2.0}), mergeAngle<P>(),
             mergeSigmas<P>()});
    }
    if (opponent == "rht") {
        using P = RandomizedHoughParameters;
        return settingsOf<RandomizedHough, P>(
            {voxel<P>({2.5, 3.5, 4.75, 7.0, 12.0}), bearing<P>(),
             row("max-distance", &P::maxDistance, {3.0, 4.0, 5.0, 6.0, 8.0}),
             row("angle", &P::cellAngle, {0.035, 0.07, 0.14, 0.2}), row("cell", &P::cellSigmas, {2.0, 8.0, 12.0}),
             row("votes", &P::votes, {3, 4, 8, 20}), row("tolerance", &P::toleranceSigmas, {2.0, 3.0, 5.0}),
             row("gap", &P::gap, {0.0, 1.5, 2.0, 3.0, 5.0, 8.0}), row("misses", &P::misses, {10, 40, 80}),
             support<P>({0.7, 1.5, 2.0}), mergeAngle<P>(), mergeSigmas<P>()});
    }
    if (opponent == "organized") {
        using P = OrganizedPlanesParameters;
        return settingsOf<OrganizedPlanes, P>(
            {row("tilt", &P::windowTilt, {degrees(2.32), degrees(3.48)}),
             row("bearing", &P::windowBearing, {degrees(0.75), degrees(1.0), degrees(2.0), degrees(3.0)}),
             row("angle", &P::angle, {0.03, 0.04, 0.07, 0.1, 0.2}),
             row("distance", &P::distanceSigmas, {2.0, 2.5, 4.0}), row("refine", &P::refineSigmas, {2.0, 4.0}),
             row("curvature", &P::maxCurvature, {0.002, 0.003, 0.01}), row("least", &P::least, {0.3, 0.5, 1.0}),
             support<P>({0.3, 0.5, 1.0}), mergeAngle<P>(), mergeSigmas<P>()});
    }
    if (opponent == "efficient-ransac") {
        using P = EfficientRansacParameters;
        return settingsOf<EfficientRansac, P>(
            {voxel<P>({2.5, 3.5, 4.75, 7.0, 12.0}), bearing<P>(), row("neighbours", &P::neighbours, {8, 12, 24, 40}),
             row("tolerance", &P::toleranceSigmas, {1.5, 2.0, 2.5, 4.0}), row("gap", &P::gap, {2.0, 3.0, 5.0, 8.0}),
             row("angle", &P::normalAngle, {0.3, 0.4, 0.7, 0.9}), row("min-points", &P::minPoints, {10, 15, 30, 50}),
             row("probability", &P::probability, {0.001, 0.05}), support<P>({0.7, 1.5, 2.0}), mergeAngle<P>(),
             mergeSigmas<P>()});
    }
    using P = RegionGrowingParameters;
    return settingsOf<RegionGrowing, P>(
        {voxel<P>({2.5, 3.5, 4.75, 7.0, 12.0}), bearing<P>(),
         row("normal-neighbours", &P::normalNeighbours, {10, 24, 40, 60}),
         row("neighbours", &P::neighbours, {8, 18, 24, 36}), row("tolerance", &P::toleranceSigmas, {2.0, 2.5, 4.0}),
         row("angle", &P::normalAngle, {0.2, 0.3, 0.6, 0.8}), row("min-points", &P::minPoints, {10, 15, 30, 50}),
         support<P>({0.7, 1.5, 2.0}), mergeAngle<P>(), mergeSigmas<P>()});
}

}  // namespace

int main(int argc, char** argv)
{
    setenv("OMP_NUM_THREADS", "1", 1);
    std::string opponent = "prosac-only";
    std::uint64_t first = 101;
    std::uint64_t last = 102;
    bool perScene = false;
    std::string only;
    std::vector<std::string> scenes{"corridor", "office", "hall", "curved", "twelve", "stairs", "clutter"};
    CLI::App program{"Tries parameters of an opponent."};
    program.add_option("opponent", opponent,
                       "prosac-only, prosac-normal, rht, organized, efficient-ransac or region-growing");
    program.add_option("--from", first, "First seed");
    program.add_option("--to", last, "Last seed");
    program.add_option("--scenes", scenes, "Rooms");
    program.add_option("--only", only, "Try one parameter");
    program.add_flag("--per-scene", perScene, "Print the rooms one by one, with the parameters as they are");
    CLI11_PARSE(program, argc, argv);

    const SimulationNoise noise = *simulationNoise("default");
    std::vector<TuningScan> scans;
    for (const std::string& name : scenes) {
        for (std::uint64_t seed = first; seed <= last; ++seed) {
            TuningScan scan{*makeScene(name, seed), {}, {}, nullptr};
            scan.scan = simulate(scan.scene, *acquisitionSettings("table8"), noise, seed);
            scan.points = pointScanOf(scan.scan.recording, noise);
            scans.push_back(std::move(scan));
        }
    }
    for (TuningScan& scan : scans)
        scan.judge = std::make_unique<Judge>(scan.scene, scan.scan, noise, 200);

    std::printf("%-28s %7s %7s %7s %7s %7s %8s\n", "setting", "recall", "precis.", "F1@50", "F1@80", "xbound", "ms");
    const auto print = [](const std::string& text, const Score& score, double time) {
        std::printf("%-28s %7.3f %7.3f %7.3f %7.3f %7.2f %8.1f\n", text.c_str(), score.at50.recall(),
                    score.at50.precision(), score.at50.f1(), score.at80.f1(), errorOverBound(score.found), time);
        std::fflush(stdout);
    };
    for (const Setting& setting : settingsFor(opponent)) {
        if (setting.text.rfind(only, 0) != 0)
            continue;
        const std::unique_ptr<Opponent> candidate = setting.make();
        Score sum;
        double time = 0.0;
        for (const TuningScan& scan : scans) {
            const OpponentRun run = runOpponent(*candidate, scan.points, *scan.judge, 1);
            if (perScene)
                print(scan.scene.name, run.score, run.milliseconds);
            sum.at50 += run.score.at50;
            sum.at80 += run.score.at80;
            sum.found.insert(sum.found.end(), run.score.found.begin(), run.score.found.end());
            time += run.milliseconds / static_cast<double>(scans.size());
        }
        print(setting.text, sum, time);
        if (perScene)
            break;
    }
    return 0;
}
