// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

#include "tests/benchmarks/paper/product_run.h"
#include "tests/benchmarks/paper/sections.h"

namespace planewright {

namespace {

using Style = ChartSeries::Style;

/// Truth and estimate of a plane as Table XII prints them.
struct PrintedPlane {
    std::array<double, 3> trueNormal;
    double trueDistance;
    std::array<double, 3> normal;
    double distance;
};
constexpr std::array<PrintedPlane, 12> kTableXII{{{{-1, 0, 0}, 12.6, {-1.000, -0.0017, -0.0029}, 12.601},
                                                  {{-1, 0, 0}, 12.28, {-0.9989, -0.0442, -0.0062}, 12.273},
                                                  {{0, 1, 0}, 2.58, {0.0059, 0.9994, 0.03337}, 2.561},
                                                  {{-1, 0, 0}, 2.11, {-0.9997, 0.0143, -0.0148}, 2.120},
                                                  {{0, 1, 0}, 3.69, {0.0040, 0.9994, 0.0327}, 3.700},
                                                  {{1, 0, 0}, 1.83, {0.9997, 0.0248, -0.0033}, 1.899},
                                                  {{0, 1, 0}, 3.37, {0.0006, 0.9988, 0.0477}, 3.399},
                                                  {{1, 0, 0}, 6.34, {0.9993, 0.0366, 0.0069}, 6.444},
                                                  {{1, 0, 0}, 10.79, {0.9997, 0.0235, 0.0025}, 10.842},
                                                  {{1, 0, 0}, 21.28, {1.0000, 0.0042, -0.0020}, 21.297},
                                                  {{0, 0, 1}, 2, {0.0009, -0.0354, 0.9993}, 1.992},
                                                  {{0, 0, -1}, 0.9, {0.0016, 0.0443, -0.9989}, 0.860}}};

std::string vectorText(const Eigen::Vector3d& v)
{
    const auto shown = [](double x) { return fixed(std::abs(x) < 5e-5 ? 0.0 : x, 4); };  // no -0.0000
    return shown(v.x()) + ", " + shown(v.y()) + ", " + shown(v.z());
}

std::string errorText(const PlaneDifference& difference)
{
    return fixed(1000.0 * difference.angle, 2) + " / " + fixed(1000.0 * difference.distance, 1);
}

/// Mean, standard deviation, largest and smallest.
std::vector<std::string> statistics(const std::vector<double>& values, double unit, int digits)
{
    if (values.empty())
        return {"–", "–", "–", "–"};
    const auto n = static_cast<double>(values.size());
    double mean = 0.0;
    for (const double v : values)
        mean += v / n;
    double variance = 0.0;
    for (const double v : values)
        variance += (v - mean) * (v - mean) / std::max(1.0, n - 1.0);
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    return {fixed(unit * mean, digits), fixed(unit * std::sqrt(variance), digits), fixed(unit * *high, digits),
            fixed(unit * *low, digits)};
}

double meanOf(const std::vector<double>& values)
{
    double sum = 0.0;
    for (const double v : values)
        sum += v / static_cast<double>(values.size());
    return sum;
}

/// The opponent of the least mean time, and that of the highest F1 at 80 % overlap.
struct Rivals {
    std::size_t fastest = 0;
    std::size_t mostAccurate = 0;
};

Rivals rivalsOf(const std::vector<ComparedScan>& scans, std::size_t methods)
{
    Rivals rivals{kPresets.size(), kPresets.size()};
    for (std::size_t m = kPresets.size(); m < methods; ++m) {
        if (meanTime(scans, m) < meanTime(scans, rivals.fastest))
            rivals.fastest = m;
        if (total(scans, m).at80.f1() > total(scans, rivals.mostAccurate).at80.f1())
            rivals.mostAccurate = m;
    }
    return rivals;
}

void writeCase(Report& report, const std::string& caption, const std::vector<ComparedScan>& scans)
{
    const std::vector<std::string> names = methodNames();
    std::vector<std::vector<std::string>> rows;
    for (std::size_t m = 0; m < names.size(); ++m) {
        const Score score = total(scans, m);
        rows.push_back({names[m], fixed(score.at50.recall(), 3), fixed(score.at50.precision(), 3),
                        fixed(score.at50.f1(), 3), fixed(score.at80.recall(), 3), fixed(score.at80.precision(), 3),
                        fixed(score.at80.f1(), 3), fixed(errorOverBound(score.found), 2),
                        fixed(meanTime(scans, m), 2)});
    }
    report.table(caption,
                 {"method", "recall 50 %", "precision 50 %", "F1 50 %", "recall 80 %", "precision 80 %", "F1 80 %",
                  "error / bound", "mean time [ms]"},
                 rows);
}

}  // namespace

void writeTwelvePlanes(Report& report, const ExperimentPlan& plan, const std::vector<ComparedScan>& scans)
{
    report.heading(2, "Twelve planes (Tables XII and XIII)");
    report.text(
        "Room `twelve` has the planes of Table XII. Errors are those of Eq. (24), e^n by atan2(|n x m|, n.m): the arc "
        "cosine of a product rounded to six digits has a step of 1.4 mrad. Five of the paper's planes share a pitch "
        "offset of 2.2 degrees, so that its column tells of calibration more than of estimation; the simulated scanner "
        "has no such offset.");
    const PlannedScan planned = scanOf("twelve", plan.settings, *simulationNoise("default"), 1);
    const Judge judge(planned.scene, planned.scan, *simulationNoise("default"), 0);
    std::vector<std::vector<std::string>> rows;
    for (std::size_t i = 0; i < kTableXII.size(); ++i) {
        const PrintedPlane& printed = kTableXII[i];
        const auto vector = [](const std::array<double, 3>& v) { return Eigen::Vector3d{v[0], v[1], v[2]}; };
        const PlaneDifference difference = differenceOf({0, vector(printed.normal).normalized(), printed.distance},
                                                        {0, vector(printed.trueNormal), printed.trueDistance});
        rows.push_back({std::to_string(i + 1), vectorText(vector(printed.trueNormal)), fixed(printed.trueDistance, 2),
                        vectorText(vector(printed.normal)) + "; " + fixed(printed.distance, 3), errorText(difference)});
    }
    for (const std::string_view preset : kPresets) {
        const Parameters parameters = presetParameters(preset);
        const ProductRun run = runProduct(planned.scan.recording, parameters, 1);
        std::vector<ComparedPlane> truth;
        std::vector<ComparedPlane> found;
        for (const TruePlane& plane : planned.scene.planes)
            truth.push_back({plane.id, plane.normal, plane.distance});
        for (const auto& plane : run.found->planes)
            found.push_back({plane->id, plane->normal, plane->distance});
        for (std::size_t i = 0; i < truth.size(); ++i) {
            // The nearest plane that was found; the twelve are far apart from one another.
            const auto nearest = std::min_element(found.begin(), found.end(), [&](const auto& a, const auto& b) {
                const PlaneDifference x = differenceOf(a, truth[i]);
                const PlaneDifference y = differenceOf(b, truth[i]);
                return x.angle + x.distance < y.angle + y.distance;
            });
            const bool isFound = nearest != found.end() && differenceOf(*nearest, truth[i]).angle < 0.1 &&
                                 differenceOf(*nearest, truth[i]).distance < 0.2;
            if (!isFound) {
                rows[i].insert(rows[i].end(), {"not found", "–"});
                continue;
            }
            const double side = nearest->normal.dot(truth[i].normal) < 0.0 ? -1.0 : 1.0;
            rows[i].push_back(vectorText(side * nearest->normal) + "; " + fixed(side * nearest->distance, 4));
            rows[i].push_back(errorText(differenceOf(*nearest, truth[i])));
        }
    }
    report.table(
        "Table XII: truth, the paper's estimates, and those of one simulated scan (n; d in m; e^n in mrad / e^d in mm)",
        {"plane", "true n", "true d [m]", "printed n; d", "printed e^n / e^d", "paper n; d", "paper e^n / e^d",
         "precise n; d", "precise e^n / e^d"},
        rows);

    const std::vector<std::string> names = methodNames();
    std::vector<std::vector<std::string>> summary{
        {"printed: PROSAC_Only", "", "17.99", "13.20", "59.34", "1.41", "18.7", "22.5", "94.8", "0.2"},
        {"printed: PROSAC_Normal", "", "15.57", "12.12", "62.83", "0.00", "21.7", "23.9", "89.1", "2.8"},
        {"printed: RHT", "", "19.38", "9.11", "39.75", "1.41", "31.5", "33.8", "109.0", "0.5"},
        {"printed: proposed", "", "21.76", "11.08", "48.79", "0.00", "32.9", "29.5", "121.9", "1.2"}};
    for (std::size_t m = 0; m < names.size(); ++m) {
        std::vector<double> angles;
        std::vector<double> distances;
        for (const ComparedScan& scan : scans) {
            if (scan.scene != "twelve")
                continue;
            for (const FoundPlane& plane : scan.methods[m].score.found) {
                angles.push_back(plane.angle);
                distances.push_back(plane.distance);
            }
        }
        std::vector<std::string> row{names[m], std::to_string(angles.size())};
        for (const auto& cells : {statistics(angles, 1000.0, 2), statistics(distances, 1000.0, 1)})
            row.insert(row.end(), cells.begin(), cells.end());
        summary.push_back(row);
    }
    report.table(
        "Table XIII: errors of the planes of Table XII that were found at 50 % overlap, " + std::to_string(plan.seeds) +
            (plan.seeds == 1 ? " scan" : " scans"),
        {"method", "planes found", "e^n mean [mrad]", "std", "max", "min", "e^d mean [mm]", "std", "max", "min"},
        summary);
}

void writeOpponents(Report& report, const ExperimentPlan& plan, const std::vector<ComparedScan>& scans)
{
    report.heading(2, "Against other extractors (Fig. 20)");
    report.text(
        "All on the same simulated scans, in one process and on one thread, times as medians over repeats; an "
        "opponent's "
        "time runs from points in memory to planes, the product's from ranges in memory to planes. Opponents are told "
        "the true noise. Counted are true planes of 200 returns or more; error / bound is the root of the median of "
        "e'Fe over 2.366, F the information of all true points of a plane.");
    const std::vector<std::string> names = methodNames();
    Chart times;
    times.title = "Time of each scan";
    times.xTitle = "scan";
    times.yTitle = "time [ms]";
    times.logY = true;
    for (std::size_t m = 0; m < names.size(); ++m) {
        ChartSeries series;
        series.name = names[m];
        for (std::size_t i = 0; i < scans.size(); ++i) {
            series.x.push_back(static_cast<double>(i + 1));
            series.y.push_back(scans[i].methods[m].milliseconds);
        }
        times.series.push_back(std::move(series));
    }
    Chart shares;
    shares.title = "Planes found: F1";
    shares.yTitle = "F1";
    Chart errors;
    errors.title = "Error over the Cramer-Rao bound, of the planes found";
    errors.yTitle = "error / bound";
    ChartSeries at50{"at 50 % overlap", {}, {}, Style::Bars, 0};
    ChartSeries at80{"at 80 % overlap", {}, {}, Style::Bars, 1};
    ChartSeries overBound{"error / bound", {}, {}, Style::Bars, 2};
    for (std::size_t m = 0; m < names.size(); ++m) {
        const Score score = total(scans, m);
        for (ChartSeries* series : {&at50, &at80, &overBound})
            series->x.push_back(static_cast<double>(m));
        at50.y.push_back(score.at50.f1());
        at80.y.push_back(score.at80.f1());
        overBound.y.push_back(errorOverBound(score.found));
        std::string label = names[m];
        if (label.rfind("CGAL ", 0) == 0 || label.rfind("PCL ", 0) == 0)
            label = label.substr(label.find(' ') + 1);
        shares.xLabels.push_back(label);
    }
    errors.xLabels = shares.xLabels;
    shares.series = {at50, at80};
    errors.series = {overBound};
    report.figure("fig-20",
                  "Fig. 20: time of each scan (" + std::to_string(scans.size()) +
                      " scans, room by room), and how many planes were found how well.",
                  {times, shares, errors}, 1150);
    writeCase(report, "Planes found, " + plan.settings + ", default noise", scans);

    std::vector<std::vector<std::string>> byScene;
    for (std::size_t m = 0; m < names.size(); ++m) {
        std::vector<std::string> row{names[m]};
        for (const std::string& scene : plan.scenes) {
            std::vector<ComparedScan> own;
            std::copy_if(scans.begin(), scans.end(), std::back_inserter(own),
                         [&](const ComparedScan& scan) { return scan.scene == scene; });
            const Score score = total(own, m);
            row.push_back(fixed(score.at50.f1(), 2) + " / " + fixed(score.at80.f1(), 2));
        }
        byScene.push_back(row);
    }
    std::vector<std::string> header{"method"};
    header.insert(header.end(), plan.scenes.begin(), plan.scenes.end());
    report.table("F1 at 50 % / at 80 % overlap by room", header, byScene);

    for (std::size_t p = 0; p < kPresets.size(); ++p) {
        std::vector<std::vector<std::string>> rows;
        for (std::size_t m = kPresets.size(); m < names.size(); ++m) {
            std::vector<double> own[2];
            std::vector<double> theirs[2];
            std::vector<FoundPlane> ownFound;
            std::vector<FoundPlane> theirFound;
            for (const FoundByBoth& both : foundByBoth(scans, p, m)) {
                own[0].push_back(both.first.angle);
                own[1].push_back(both.first.distance);
                theirs[0].push_back(both.second.angle);
                theirs[1].push_back(both.second.distance);
                ownFound.push_back(both.first);
                theirFound.push_back(both.second);
            }
            std::vector<std::string> row{names[m], std::to_string(ownFound.size())};
            for (std::size_t k = 0; k < 2; ++k) {
                for (const auto& summary :
                     {std::pair{meanOf(own[k]), meanOf(theirs[k])}, std::pair{median(own[k]), median(theirs[k])}}) {
                    row.push_back(fixed(1000.0 * summary.first, 2) + " : " + fixed(1000.0 * summary.second, 2) + " (" +
                                  (summary.first > 0.0 ? fixed(summary.second / summary.first, 2) : "–") + ")");
                }
            }
            row.push_back(fixed(errorOverBound(ownFound), 2) + " : " + fixed(errorOverBound(theirFound), 2));
            rows.push_back(row);
        }
        report.table(
            "Errors on the planes that both found, `" + std::string(kPresets[p]) + "` : opponent (opponent / product)",
            {"opponent", "planes", "e^n mean [mrad]", "e^n median [mrad]", "e^d mean [mm]", "e^d median [mm]",
             "error / bound"},
            rows);
    }

    const Rivals rivals = rivalsOf(scans, names.size());
    std::vector<std::vector<std::string>> speed;
    for (std::size_t m = kPresets.size(); m < names.size(); ++m) {
        std::vector<std::string> row{
            names[m] + (m == rivals.fastest ? " (fastest)" : "") + (m == rivals.mostAccurate ? " (most accurate)" : ""),
            fixed(meanTime(scans, m), 1)};
        for (std::size_t p = 0; p < kPresets.size(); ++p) {
            std::vector<double> ratios;
            for (const ComparedScan& scan : scans)
                ratios.push_back(scan.methods[m].milliseconds / scan.methods[p].milliseconds);
            row.push_back(fixed(median(ratios), 1) + " (" + fixed(*std::min_element(ratios.begin(), ratios.end()), 1) +
                          " to " + fixed(*std::max_element(ratios.begin(), ratios.end()), 1) + ")");
        }
        speed.push_back(row);
    }
    report.table("Speed: how many times as long an opponent takes on the same scan, median (least to most)",
                 {"opponent", "mean time [ms]", "against paper", "against precise"}, speed);
}

void writeVariations(Report& report, const ExperimentPlan& plan)
{
    if (!plan.variations)
        return;
    report.heading(2, "More noise, fewer points, more points");
    SimulationNoise noisy = *simulationNoise("default");
    noisy.rangeConstant = 0.015;
    noisy.pitch = degrees(0.15);
    const SimulationNoise usual = *simulationNoise("default");
    report.text("No parameter of the product is changed, and it is not told of the noise; opponents are told.");
    for (const ComparisonCase& what :
         {ComparisonCase{"15 mm range noise and 0.15° pitch noise, 137 x 721", "table8", noisy, 200},
          ComparisonCase{"56 x 361, true planes of 50 returns or more", "table10-1", usual, 50},
          ComparisonCase{"257 x 801", "table10-5", usual, 200}})
        writeCase(report, what.title, compareMethods(plan, what));
}

}  // namespace planewright
