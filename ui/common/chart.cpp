// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/common/chart.h"

#include "core/formats/number_text.h"

namespace planewright {

ChartTable tableOf(const Chart& chart)
{
    ChartTable table;
    table.headings.push_back(chart.xTitle);
    std::vector<const ChartSeries*> measured;
    for (const ChartSeries& one : chart.series) {
        if (one.style == ChartSeries::Style::Limit || one.style == ChartSeries::Style::Fit)
            continue;
        measured.push_back(&one);
        table.headings.push_back(chart.yTitle.empty() ? one.name : one.name + " [" + chart.yTitle + "]");
    }
    if (measured.empty())
        return table;
    for (std::size_t i = 0; i < measured.front()->x.size(); ++i) {
        std::vector<std::string>& row = table.rows.emplace_back();
        row.push_back(i < chart.xLabels.size() ? chart.xLabels[i] : formatNumber(measured.front()->x[i]));
        for (const ChartSeries* one : measured)
            row.push_back(formatNumber(one->y[i]));
    }
    return table;
}

ChartTable tableOf(const std::vector<Chart>& charts)
{
    ChartTable whole;
    for (const Chart& chart : charts) {
        if (!chart.overSteps)
            continue;
        const ChartTable table = tableOf(chart);
        if (whole.headings.empty()) {
            whole = table;
            continue;
        }
        whole.headings.insert(whole.headings.end(), table.headings.begin() + 1, table.headings.end());
        for (std::size_t i = 0; i < whole.rows.size() && i < table.rows.size(); ++i)
            whole.rows[i].insert(whole.rows[i].end(), table.rows[i].begin() + 1, table.rows[i].end());
    }
    return whole.headings.empty() && !charts.empty() ? tableOf(charts.front()) : whole;
}

std::string tabSeparated(const ChartTable& table)
{
    std::string text;
    const auto add = [&text](const std::vector<std::string>& cells) {
        for (std::size_t i = 0; i < cells.size(); ++i)
            text += (i == 0 ? "" : "\t") + cells[i];
        text += '\n';
    };
    add(table.headings);
    for (const auto& row : table.rows)
        add(row);
    return text;
}

}  // namespace planewright
