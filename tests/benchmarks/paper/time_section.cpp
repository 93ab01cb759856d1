// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <chrono>
#include <cmath>

#include "core/evaluation/curve_fit.h"
#include "core/evaluation/data_access_ratio.h"
#include "tests/benchmarks/paper/product_run.h"
#include "tests/benchmarks/paper/sections.h"

namespace planewright {

namespace {

using Style = ChartSeries::Style;

double millisecondsOf(std::chrono::nanoseconds time)
{
    return std::chrono::duration<double, std::milli>(time).count();
}

/// A curve over the scan steps; the last pass is not a step.
ChartSeries stepCurve(const std::string& name, const ProductRun& run, const auto& value)
{
    ChartSeries series;
    series.name = name;
    for (std::size_t k = 0; k + 1 < run.reports.size(); ++k) {
        series.x.push_back(static_cast<double>(k));
        series.y.push_back(value(run.reports[k]));
    }
    return series;
}

/// Median time of each phase at each step over some runs, so that a hiccup of the machine is not taken for a phase.
ProductRun medianPhases(const Recording& recording, const Parameters& parameters, int repeats)
{
    std::vector<ProductRun> runs;
    for (int i = 0; i < repeats; ++i)
        runs.push_back(runProduct(recording, parameters, 1));
    ProductRun middle = runs.front();
    for (std::size_t k = 0; k < middle.reports.size(); ++k) {
        for (std::size_t phase = 0; phase < kPhases; ++phase) {
            std::vector<double> times;
            for (const ProductRun& run : runs)
                times.push_back(static_cast<double>(run.reports[k].times[phase].count()));
            middle.reports[k].times[phase] = std::chrono::nanoseconds(std::llround(median(times)));
        }
    }
    return middle;
}

void writeStepCurves(Report& report, const std::vector<ProductRun>& runs)
{
    struct Curve {
        const char* title;
        const char* axis;
        double (*value)(const StepReport&);
    };
    static constexpr Curve kCurves[]{
        {"(a) fitted line segments", "segments", [](const StepReport& r) { return double(r.counts.fitted); }},
        {"(b) unfitted line segments", "segments", [](const StepReport& r) { return double(r.counts.unfitted); }},
        {"(c) planes", "planes", [](const StepReport& r) { return double(r.counts.planes); }},
        {"(d) mean fitting error E", "E", [](const StepReport& r) { return r.counts.meanError; }}};
    std::vector<Chart> charts;
    for (const Curve& curve : kCurves) {
        Chart chart;
        chart.title = curve.title;
        chart.xTitle = "scan step";
        chart.yTitle = curve.axis;
        for (std::size_t i = 0; i < runs.size(); ++i)
            chart.series.push_back(stepCurve(std::string(kPresets[i]), runs[i], curve.value));
        charts.push_back(std::move(chart));
    }
    report.figure("fig-15", "Fig. 15: the extraction of a scan step by step (hall, seed 1).", charts);
}

void writePhases(Report& report, const std::vector<ProductRun>& runs)
{
    std::vector<Chart> charts;
    Chart bars;
    bars.title = "Mean time of each phase, where it was due";
    bars.yTitle = "time [ms]";
    std::vector<std::vector<std::string>> rows;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        Chart chart;
        chart.title = "Preset " + std::string(kPresets[i]);
        chart.xTitle = "scan step";
        chart.yTitle = "time [ms]";
        ChartSeries bar{std::string(kPresets[i]), {}, {}, Style::Bars, static_cast<int>(i)};
        std::vector<std::string> row{std::string(kPresets[i])};
        const ScheduleParameters schedule;
        for (std::size_t phase = 0; phase < kPhases; ++phase) {
            const auto isDue = [&](int step) {
                switch (static_cast<Phase>(phase)) {
                    case Phase::Fit:
                        return schedule.fitsPlanesAt(step);
                    case Phase::SplitMerge:
                        return schedule.splitsAndMergesAt(step);
                    case Phase::Remaining:
                        return schedule.fitsRemainingAt(step);
                    default:
                        return true;
                }
            };
            double sum = 0.0;
            int count = 0;
            if (static_cast<Phase>(phase) == Phase::Finish) {
                for (const auto& time : runs[i].reports.back().times)
                    sum += millisecondsOf(time);
                count = 1;
            } else {
                chart.series.push_back(
                    stepCurve(std::string(kPhaseNames[phase]), runs[i],
                              [phase](const StepReport& r) { return millisecondsOf(r.times[phase]); }));
                for (std::size_t k = 0; k + 1 < runs[i].reports.size(); ++k) {
                    if (!isDue(static_cast<int>(k)))
                        continue;
                    sum += millisecondsOf(runs[i].reports[k].times[phase]);
                    ++count;
                }
            }
            bar.x.push_back(static_cast<double>(phase));
            bar.y.push_back(sum / std::max(1, count));
            row.push_back(fixed(1000.0 * bar.y.back(), 1));
            if (i == 0)
                bars.xLabels.emplace_back(kPhaseNames[phase]);
        }
        double slowest = 0.0;
        for (std::size_t k = 0; k + 1 < runs[i].reports.size(); ++k) {
            double total = 0.0;
            for (const auto& time : runs[i].reports[k].times)
                total += millisecondsOf(time);
            slowest = std::max(slowest, total);
        }
        row.push_back(fixed(1000.0 * slowest, 1));
        rows.push_back(row);
        bars.series.push_back(std::move(bar));
        charts.push_back(std::move(chart));
    }
    report.figure("fig-17", "Fig. 17: time of each phase against the scan step (hall, seed 1).", charts);
    report.figure("fig-18",
                  "Fig. 18: mean time of each phase over the steps at which it was due; `finish` is the last pass.",
                  {bars});
    std::vector<std::string> header{"preset"};
    for (const std::string_view name : kPhaseNames)
        header.push_back(std::string(name) + " [us]");
    header.emplace_back("slowest step [us]");
    report.table("Fig. 18 in numbers (the paper's steps take up to 10 ms)", header, rows);
}

/// Measured points, the straight line and the power through them.
void addGrowth(Chart& chart, const std::string& name, int colour, const std::vector<double>& x,
               const std::vector<double>& y)
{
    const LineFit line = lineThrough(x, y);
    const PowerFit power = powerThrough(x, y);
    ChartSeries fit{name + ": straight line R2 " + fixed(line.explained, 3) + ", exponent " + fixed(power.exponent, 2),
                    {},
                    {},
                    Style::Line,
                    colour};
    const auto [low, high] = std::minmax_element(x.begin(), x.end());
    constexpr int kPieces = 40;
    for (int i = 0; i <= kPieces; ++i) {
        const double at = *low + (*high - *low) * i / kPieces;
        fit.x.push_back(at);
        fit.y.push_back(power.factor * std::pow(at, power.exponent));
    }
    chart.series.push_back({name, x, y, Style::Points, colour});
    chart.series.push_back(std::move(fit));
}

}  // namespace

void writeSteps(Report& report, const ExperimentPlan& plan)
{
    report.heading(2, "Step by step (Fig. 15, 17 and 18)");
    const PlannedScan planned = scanOf("hall", plan.settings, *simulationNoise("default"), 1);
    std::vector<ProductRun> runs;
    for (const std::string_view preset : kPresets)
        runs.push_back(medianPhases(planned.scan.recording, presetParameters(preset), plan.productRepeats));
    writeStepCurves(report, runs);
    writePhases(report, runs);
}

void writeGrowth(Report& report, const ExperimentPlan& plan)
{
    report.heading(2, "Growth of time (Table X, Fig. 16)");
    report.text(
        "One room (office, seed 1) at the paper's eight settings. In the paper's column 7 the points are those of "
        "whole "
        "slices, 444 x 721 = 320,124 (printed 320,214, no multiple of 721), and the ratio is 2 x 4320 / 320,124 = 2.70 "
        "% "
        "(printed 2.69).");
    report.table("Table X of the paper, corrected (computer A)", {"measure", "1", "2", "3", "4", "5", "6", "7", "8"},
                 {{"scan points", "20,216", "40,071", "86,520", "120,697", "205,857", "241,394", "320,124", "410,913"},
                  {"total lines", "397", "779", "1,139", "1,508", "2,558", "2,972", "4,320", "5,045"},
                  {"DAR [%]", "3.93", "3.89", "2.63", "2.50", "2.49", "2.46", "2.70", "2.46"},
                  {"time [ms]", "68.9", "127.4", "293.9", "411.7", "630.1", "914.6", "1502.2", "1883.6"}});
    const std::vector<double> paperPoints{20216, 40071, 86520, 120697, 205857, 241394, 320124, 410913};
    const std::vector<double> paperLines{397, 779, 1139, 1508, 2558, 2972, 4320, 5045};
    const std::vector<double> paperTimes{68.9, 127.4, 293.9, 411.7, 630.1, 914.6, 1502.2, 1883.6};
    Chart bySegments;
    bySegments.title = "(a) time against line segments";
    bySegments.xTitle = "line segments";
    bySegments.yTitle = "time [ms]";
    bySegments.logX = bySegments.logY = true;
    Chart byPoints = bySegments;
    byPoints.title = "(b) time against scan points";
    byPoints.xTitle = "scan points";
    std::vector<std::vector<std::string>> fits;
    const auto add = [&](const std::string& name, int colour, const std::vector<double>& lines,
                         const std::vector<double>& points, const std::vector<double>& times) {
        addGrowth(bySegments, name, colour, lines, times);
        addGrowth(byPoints, name, colour, points, times);
        const LineFit line = lineThrough(lines, times);
        fits.push_back({name, fixed(1000.0 * line.slope, 2), fixed(line.explained, 4),
                        fixed(powerThrough(lines, times).exponent, 2), fixed(powerThrough(points, times).exponent, 2)});
    };
    for (std::size_t i = 0; i < kPresets.size(); ++i) {
        std::vector<std::string> header{"measure"};
        std::vector<std::vector<std::string>> rows{{"slices x beams"}, {"scan points"}, {"total lines"},
                                                   {"DAR [%]"},        {"planes"},      {"time [ms]"}};
        std::vector<double> points;
        std::vector<double> lines;
        std::vector<double> times;
        for (int column = 1; column <= plan.tableXColumns; ++column) {
            const PlannedScan planned =
                scanOf("office", "table10-" + std::to_string(column), *simulationNoise("default"), 1);
            const ProductRun run =
                runProduct(planned.scan.recording, presetParameters(kPresets[i]), plan.productRepeats);
            const std::size_t count = pointsOf(planned.scan.recording);
            points.push_back(static_cast<double>(count));
            lines.push_back(segmentsOf(run));
            times.push_back(run.milliseconds);
            header.push_back(std::to_string(column));
            const std::vector<std::string> cells{std::to_string(planned.scan.recording.slices.size()) + " x " +
                                                     std::to_string(planned.scan.recording.description.beams),
                                                 std::to_string(count),
                                                 fixed(lines.back(), 0),
                                                 fixed(dataAccessRatio(run.found->segments.segmentCount(), count), 2),
                                                 std::to_string(run.found->planes.size()),
                                                 fixed(times.back(), 2)};
            for (std::size_t r = 0; r < rows.size(); ++r)
                rows[r].push_back(cells[r]);
        }
        report.table("Table X, preset " + std::string(kPresets[i]), header, rows);
        add(std::string(kPresets[i]), static_cast<int>(i), lines, points, times);
    }
    add("printed in the paper", 6, paperLines, paperPoints, paperTimes);
    report.figure("fig-16",
                  "Fig. 16: time against (a) line segments and (b) scan points, with the power that fits best.",
                  {bySegments, byPoints});
    report.table("Fig. 16 in numbers",
                 {"preset", "us a segment", "R² of the straight line", "exponent in segments", "exponent in points"},
                 fits);
}

}  // namespace planewright
