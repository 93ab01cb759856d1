// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/formats/text_lines.h"

namespace planewright {

/// Appends a text cell as RFC 4180 wants it: in quotes, quotes doubled, where it holds a comma, a quote or a line end.
/// A text that begins with `= + - @` gets a `'` before it, so that no spreadsheet takes it for a formula.
void appendCsvText(std::string& row, std::string_view text);

/// Appends a text cell in quotes in any case.
void appendQuotedCsvText(std::string& row, std::string_view text);

/// The text that appendCsvText was given: takes the `'` before `= + - @` off.
std::string_view unguarded(std::string_view cell);

/// A row of cells after RFC 4180, and the line at which it begins.
struct CsvRecord {
    std::size_t line = 0;
    std::vector<std::string> cells;
};

/// The next record of a text; cells in quotes may go over several lines. Nothing at the end, and nothing with `problem`
/// set where quotes are wrong.
std::optional<CsvRecord> nextCsvRecord(TextLines& lines, std::size_t longestRecord, std::string& problem);

}  // namespace planewright
