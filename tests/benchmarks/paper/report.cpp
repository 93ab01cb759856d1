// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tests/benchmarks/paper/report.h"

#include <array>
#include <cassert>
#include <cstdio>
#include <fstream>

namespace planewright {

void Report::heading(int level, const std::string& text)
{
    markdown_ += std::string(static_cast<std::size_t>(level), '#') + " " + text + "\n\n";
}

void Report::text(const std::string& paragraph)
{
    markdown_ += paragraph + "\n\n";
}

void Report::table(const std::string& caption, const std::vector<std::string>& header,
                   const std::vector<std::vector<std::string>>& rows)
{
    markdown_ += "**" + caption + "**\n\n";
    const auto line = [&](const std::vector<std::string>& cells) {
        assert(cells.size() == header.size());
        for (const std::string& cell : cells)
            markdown_ += "| " + cell + " ";
        markdown_ += "|\n";
    };
    line(header);
    line(std::vector<std::string>(header.size(), "---"));
    for (const auto& row : rows)
        line(row);
    markdown_ += "\n";
}

void Report::figure(const std::string& name, const std::string& caption, const std::vector<Chart>& charts, int width)
{
    const std::string file = name + ".png";
    if (!writeCharts(charts, folder_ + "/" + file, width)) {
        std::fprintf(stderr, "paper_report: the figure %s could not be drawn\n", file.c_str());
        failed_ = true;
    }
    markdown_ += "![" + caption + "](" + file + ")\n\n*" + caption + "*\n\n";
}

bool Report::write() const
{
    std::ofstream out(folder_ + "/report.md");
    out << markdown_;
    out.close();
    return !failed_ && out.good();
}

std::string fixed(double value, int digits)
{
    std::array<char, 64> text{};
    std::snprintf(text.data(), text.size(), "%.*f", digits, value);
    return text.data();
}

}  // namespace planewright
