// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace planewright {

/// A piece of a foreign file for a message: what is not printable ASCII becomes '?', and after 40 characters it is cut
/// and ends with "...", so that no file can play with the terminal or flood it.
std::string printableText(std::string_view text);

/// The same between quotes.
std::string quotedText(std::string_view text);

/// `file: line 3, column 5 (r1): ` — the beginning of every message about a place in a file. A line or column of 0 and
/// an empty name are left out; names go through printableText().
std::string placeInFile(std::string_view fileName, std::size_t line, std::size_t column = 0,
                        std::string_view name = {});

/// True where a text is well-formed UTF-8 without control characters but the tabulator.
bool isPlainUtf8(std::string_view text);

}  // namespace planewright
