// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

namespace planewright {

/// A curve or a set of points of a chart.
struct ChartSeries {
    enum class Style { Line, Points, Bars };
    std::string name;  ///< in the legend
    std::vector<double> x;
    std::vector<double> y;
    Style style = Style::Line;
    int colour = -1;  ///< number of a colour of the palette; −1 = the next
};

/// A chart of two axes, as the report shows it.
struct Chart {
    std::string title;
    std::string xTitle;  ///< with unit
    std::string yTitle;  ///< with unit
    std::vector<ChartSeries> series;
    bool logX = false;                 ///< axis in powers of ten
    bool logY = false;                 ///< axis in powers of ten
    bool legend = true;                ///< where there is more than one series
    std::vector<std::string> xLabels;  ///< in place of numbers, at 0, 1, 2, …
};

/// Draws charts below one another, each of this size in pixels, and writes them as one PNG. False where that fails,
/// or where the picture is of one colour only, as it is when OpenGL is set up wrongly.
bool writeCharts(const std::vector<Chart>& charts, const std::string& path, int width = 900, int height = 420);

}  // namespace planewright
