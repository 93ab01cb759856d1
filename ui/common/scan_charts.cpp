// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/common/scan_charts.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <limits>
#include <utility>

#include "core/evaluation/curve_fit.h"

namespace planewright {

namespace {

/// The phases of a step, without the forced last pass.
constexpr std::size_t kStepPhases = kPhases - 1;
constexpr std::array<const char*, kStepPhases> kShortPhases{"extract", "assign", "cluster", "fit", "split", "rest"};
constexpr std::array<const char*, kStepPhases> kPhaseWords{"extract segments", "assign",          "cluster",
                                                           "fit planes",       "split and merge", "fit remaining"};

double milliseconds(std::chrono::nanoseconds time)
{
    return std::chrono::duration<double, std::milli>(time).count();
}

/// The steps of a history, as columns.
struct Steps {
    std::vector<double> numbers;  ///< from 1
    std::vector<int> places;
    std::vector<const StepReport*> reports;
};

Steps stepsOf(const std::vector<std::shared_ptr<const Snapshot>>& history)
{
    Steps steps;
    for (std::size_t place = 0; place < history.size(); ++place) {
        const StepReport& report = history[place]->report;
        if (report.step < 0)
            continue;
        steps.numbers.push_back(report.step + 1.0);
        steps.places.push_back(static_cast<int>(place));
        steps.reports.push_back(&report);
    }
    return steps;
}

template <class Value>
std::vector<double> columnOf(const Steps& steps, Value valueOf)
{
    std::vector<double> column;
    column.reserve(steps.reports.size());
    for (const StepReport* report : steps.reports)
        column.push_back(valueOf(*report));
    return column;
}

template <class Value>
Chart overSteps(const char* id, const char* title, const char* series, const char* unit, int colour, const Steps& steps,
                Value valueOf)
{
    Chart chart;
    chart.id = id;
    chart.title = title;
    chart.xTitle = "step";
    chart.yTitle = unit;
    chart.overSteps = true;
    chart.places = steps.places;
    chart.series.push_back({series, steps.numbers, columnOf(steps, valueOf), ChartSeries::Style::Line, colour});
    return chart;
}

ChartSeries limitOf(const char* name, double limit)
{
    return {name, {0.0}, {limit}, ChartSeries::Style::Limit, 0};
}

std::string rounded(const char* format, double value)
{
    std::array<char, 48> text{};
    std::snprintf(text.data(), text.size(), format, value);
    return text.data();
}

Chart phaseTimes(const Steps& steps)
{
    Chart chart;
    chart.id = "phaseTimes";
    chart.title = "Time of each phase";
    chart.xTitle = "step";
    chart.yTitle = "ms";
    chart.overSteps = true;
    chart.places = steps.places;
    for (std::size_t phase = 0; phase < kStepPhases; ++phase)
        chart.series.push_back({kPhaseWords[phase], steps.numbers,
                                columnOf(steps, [&](const StepReport& r) { return milliseconds(r.times[phase]); }),
                                ChartSeries::Style::Stacked, static_cast<int>(phase)});
    chart.series.push_back(limitOf("10 ms", kStepGoal));
    chart.series.push_back(limitOf("25 ms", kStepLimit));
    return chart;
}

/// A phase that did not run has a time of exactly zero, where there was a clock.
Chart phaseAverages(const Steps& steps)
{
    Chart chart;
    chart.id = "phaseAverages";
    chart.title = "Average time of each phase";
    chart.xTitle = "phase, when it ran";
    chart.yTitle = "ms";
    ChartSeries averages{"average", {}, {}, ChartSeries::Style::Bars, 0};
    for (std::size_t phase = 0; phase < kStepPhases && !steps.reports.empty(); ++phase) {
        double sum = 0.0;
        int ran = 0;
        for (const StepReport* report : steps.reports) {
            sum += milliseconds(report->times[phase]);
            ran += report->times[phase].count() > 0 ? 1 : 0;
        }
        chart.xLabels.emplace_back(kShortPhases[phase]);
        averages.x.push_back(static_cast<double>(phase));
        averages.y.push_back(ran > 0 ? sum / ran : 0.0);
    }
    chart.series.push_back(std::move(averages));
    return chart;
}

Chart timeOfSegments(const Steps& steps)
{
    Chart chart;
    chart.id = "timeOfSegments";
    chart.title = "Time against segments";
    chart.xTitle = "segments of the scan so far";
    chart.yTitle = "ms";
    chart.places = steps.places;
    const auto segments =
        columnOf(steps, [](const StepReport& r) { return static_cast<double>(r.counts.fitted + r.counts.unfitted); });
    double sum = 0.0;
    const auto times = columnOf(steps, [&sum](const StepReport& r) {
        for (std::size_t phase = 0; phase < kStepPhases; ++phase)
            sum += milliseconds(r.times[phase]);
        return sum;
    });
    chart.series.push_back({"total time", segments, times, ChartSeries::Style::Points, 0});
    if (segments.size() < 2)
        return chart;
    const LineFit line = lineThrough(segments, times);
    const auto [least, most] = std::minmax_element(segments.begin(), segments.end());
    chart.series.push_back({"straight line",
                            {*least, *most},
                            {line.intercept + line.slope * *least, line.intercept + line.slope * *most},
                            ChartSeries::Style::Fit,
                            1});
    chart.note = rounded("%.3g ms", line.intercept) + rounded(" %+.3g ms per segment", line.slope) +
                 rounded(", R² %.2f", line.explained);
    return chart;
}

}  // namespace

std::vector<Chart> scanCharts(const std::vector<std::shared_ptr<const Snapshot>>& history,
                              std::optional<double> errorLimit)
{
    const Steps steps = stepsOf(history);
    std::vector<Chart> charts;
    charts.push_back(overSteps("fittedSegments", "Fitted segments", "fitted", "segments", 0, steps,
                               [](const StepReport& r) { return r.counts.fitted; }));
    charts.push_back(overSteps("unfittedSegments", "Unfitted segments", "unfitted", "segments", 1, steps,
                               [](const StepReport& r) { return r.counts.unfitted; }));
    charts.push_back(overSteps("planes", "Planes", "planes", "planes", 2, steps,
                               [](const StepReport& r) { return r.counts.planes; }));
    for (Chart& chart : charts)
        chart.counts = true;
    charts.push_back(overSteps("meanError", "Mean fitting error E", "mean E", "", 3, steps, [](const StepReport& r) {
        return r.counts.planes > 0 ? r.counts.meanError : std::numeric_limits<double>::quiet_NaN();
    }));
    charts.back().series.push_back(errorLimit ? limitOf("limit", *errorLimit) : limitOf("expected", 1.0));
    charts.push_back(phaseTimes(steps));
    charts.push_back(phaseAverages(steps));
    charts.push_back(timeOfSegments(steps));
    return charts;
}

}  // namespace planewright
