// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/cli/text.h"

#include <algorithm>
#include <charconv>

#include "core/formats/number_text.h"

namespace planewright {

double rounded(double value)
{
    const std::string text = formatNumber(value);
    std::from_chars(text.data(), text.data() + text.size(), value);
    return value;
}

std::string tableText(const std::vector<std::vector<std::string>>& rows)
{
    std::vector<std::size_t> widths(rows.front().size());
    for (const auto& row : rows) {
        for (std::size_t column = 0; column < row.size(); ++column)
            widths[column] = std::max(widths[column], row[column].size());
    }
    const auto isNumeric = [&](std::size_t column) {
        return rows.size() > 1 && rows[1][column].find_first_of("0123456789-.") == 0;
    };
    std::string text;
    for (const auto& row : rows) {
        std::string line;
        for (std::size_t column = 0; column < row.size(); ++column) {
            const std::string blanks(widths[column] - row[column].size(), ' ');
            line += column == 0 ? "" : "  ";
            line += isNumeric(column) ? blanks + row[column] : row[column] + blanks;
        }
        line.erase(line.find_last_not_of(' ') + 1);
        text += line + '\n';
    }
    return text;
}

}  // namespace planewright
