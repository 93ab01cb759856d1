// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/charts/chart_ranges.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace planewright {

namespace {

constexpr double kRoom = 1.08;     // above the highest number
constexpr double kFarLimit = 4.0;  // times the highest number

/// Which points of a chart are drawn where several share a column of pixels: the lowest and the highest of a line, the
/// highest of what is stacked. All of them where there is room.
std::vector<std::size_t> drawnPoints(const std::vector<double>& x, const std::vector<double>& y, double columns,
                                     bool isStacked)
{
    std::vector<std::size_t> drawn;
    const double span = x.empty() ? 0.0 : x.back() - x.front();
    if (static_cast<double>(x.size()) <= columns || span <= 0.0) {
        drawn.resize(x.size());
        std::iota(drawn.begin(), drawn.end(), std::size_t{0});
        return drawn;
    }
    for (std::size_t first = 0; first < x.size();) {
        const double column = std::floor((x[first] - x.front()) / span * columns);
        std::size_t low = first;
        std::size_t high = first;
        std::size_t next = first;
        for (; next < x.size() && std::floor((x[next] - x.front()) / span * columns) == column; ++next) {
            low = y[next] < y[low] ? next : low;
            high = y[next] > y[high] ? next : high;
        }
        if (!isStacked && low != high)
            drawn.push_back(std::min(low, high));
        drawn.push_back(isStacked ? high : std::max(low, high));
        first = next;
    }
    return drawn;
}

std::vector<double> chosen(const std::vector<double>& numbers, const std::vector<std::size_t>& which)
{
    std::vector<double> some;
    some.reserve(which.size());
    for (const std::size_t i : which)
        some.push_back(numbers[i]);
    return some;
}

}  // namespace

ChartRanges rangesOf(const Chart& chart)
{
    ChartRanges ranges;
    double most = 0.0;
    bool first = true;
    std::vector<double> stacked;
    for (const ChartSeries& one : chart.series) {
        if (one.style == ChartSeries::Style::Limit)
            continue;
        if (one.style == ChartSeries::Style::Stacked)
            stacked.resize(std::max(stacked.size(), one.y.size()));
        for (std::size_t i = 0; i < one.x.size(); ++i) {
            ranges.lowX = first ? one.x[i] : std::min(ranges.lowX, one.x[i]);
            ranges.highX = first ? one.x[i] : std::max(ranges.highX, one.x[i]);
            first = false;
            most = std::max(most, one.style == ChartSeries::Style::Stacked ? stacked[i] += one.y[i] : one.y[i]);
        }
    }
    if (chart.overSteps) {
        ranges.lowX = first ? 1.0 : ranges.lowX;
        ranges.highX = std::max(ranges.highX, ranges.lowX + 1.0);
    }
    if (!chart.xLabels.empty()) {
        ranges.lowX = -0.6;
        ranges.highX = static_cast<double>(chart.xLabels.size()) - 0.4;
    } else if (!chart.overSteps) {
        ranges.lowX = std::min(ranges.lowX, 0.0);
        ranges.highX = std::max(ranges.highX * 1.03, ranges.lowX + 1.0);
    }
    // A limit is seen where it leaves the rest readable; a higher one as soon as the one below it is passed.
    double seen = most;
    for (const ChartSeries& one : chart.series) {
        if (one.style == ChartSeries::Style::Limit && seen <= most && (one.y.front() < kFarLimit * most || most == 0.0))
            seen = std::max(seen, one.y.front());
    }
    ranges.highY = seen > 0.0 ? kRoom * seen : 10.0;
    return ranges;
}

double tickStep(double span, double most, double least)
{
    const double wanted = span / std::max(1.0, most);
    const double decade = std::pow(10.0, std::floor(std::log10(wanted)));
    for (const double digit : {1.0, 2.0, 5.0, 10.0}) {
        if (digit * decade >= wanted)
            return std::max(least, digit * decade);
    }
    return std::max(least, 10.0 * decade);
}

Chart inPieces(Chart chart)
{
    std::vector<ChartSeries> pieces;
    for (ChartSeries& one : chart.series) {
        if (one.style != ChartSeries::Style::Line) {
            pieces.push_back(std::move(one));
            continue;
        }
        bool begins = true;
        for (std::size_t i = 0; i < one.y.size(); ++i) {
            if (std::isnan(one.y[i])) {
                begins = true;
                continue;
            }
            if (begins)
                pieces.push_back({one.name, {}, {}, one.style, one.colour});
            begins = false;
            pieces.back().x.push_back(one.x[i]);
            pieces.back().y.push_back(one.y[i]);
        }
    }
    chart.series = std::move(pieces);
    return chart;
}

Chart thinned(Chart chart, double columns)
{
    std::vector<double> total;
    for (const ChartSeries& one : chart.series) {
        total.resize(std::max(total.size(), one.style == ChartSeries::Style::Stacked ? one.y.size() : 0));
        for (std::size_t i = 0; one.style == ChartSeries::Style::Stacked && i < one.y.size(); ++i)
            total[i] += one.y[i];
    }
    for (ChartSeries& one : chart.series) {
        const bool isStacked = one.style == ChartSeries::Style::Stacked;
        if (!isStacked && one.style != ChartSeries::Style::Line && one.style != ChartSeries::Style::Points)
            continue;
        const auto which = drawnPoints(one.x, isStacked ? total : one.y, columns, isStacked);
        one.x = chosen(one.x, which);
        one.y = chosen(one.y, which);
    }
    return chart;
}

}  // namespace planewright
