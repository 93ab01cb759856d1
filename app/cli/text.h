// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/types/angle_text.h"

namespace planewright {

/// A number for JSON and lists: rounded to nine significant digits, as in all files.
double rounded(double value);

/// Rows of cells in columns, two blanks apart, numbers to the right. The first row is the heading; a column is one of
/// numbers where its first cell below begins with a digit, '-' or '.'.
std::string tableText(const std::vector<std::vector<std::string>>& rows);

/// Words as "a, b, c".
template <class Words>
std::string joined(const Words& words)
{
    std::string text;
    for (const auto& word : words)
        text += (text.empty() ? "" : ", ") + std::string{word};
    return text;
}

}  // namespace planewright
