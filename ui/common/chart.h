// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

namespace planewright {

/// Numbers that belong together in a chart.
struct ChartSeries {
    enum class Style {
        Line,
        Points,
        Stacked,  ///< stands on the stacked series before it
        Bars,
        Limit,  ///< a level line that says what is too much; of its y only the first counts
        Fit,    ///< a line that was fitted to others
    };
    std::string name;
    std::vector<double> x;
    std::vector<double> y;  ///< as many; NaN where there is nothing to say, and a line has a gap
    Style style = Style::Line;
    int colour = 0;  ///< number of a colour of the palette
};

/// A chart of two axes.
struct Chart {
    std::string id;  ///< for settings and tests
    std::string title;
    std::string xTitle;  ///< with unit
    std::string yTitle;  ///< its unit; empty for none
    std::vector<ChartSeries> series;
    std::vector<std::string> xLabels;  ///< in place of numbers, at 0, 1, 2, …
    std::string note;                  ///< what its numbers say, in a few words
    bool overSteps = false;            ///< x is a step, from 1
    bool counts = false;               ///< y is a whole number
    std::vector<int> places;           ///< in the scan's history, of the points of the first series; empty for none

    /// True while there is nothing to be seen.
    bool isEmpty() const
    {
        for (const ChartSeries& one : series) {
            if (one.style != ChartSeries::Style::Limit && !one.x.empty())
                return false;
        }
        return true;
    }
};

/// The numbers of a chart as a table: a column for x and one for each series that was measured.
struct ChartTable {
    std::vector<std::string> headings;
    std::vector<std::vector<std::string>> rows;
};
ChartTable tableOf(const Chart& chart);
/// Of several charts: those over the same steps in one table; without any of these, the first alone.
ChartTable tableOf(const std::vector<Chart>& charts);

/// The same as text with tabs and headings, a line for each row, as spreadsheets take it.
std::string tabSeparated(const ChartTable& table);

}  // namespace planewright
