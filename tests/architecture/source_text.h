// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace planewright::architecture {

/// One #include line.
struct Include {
    int line = 0;        ///< from 1
    std::string header;  ///< between the brackets or quotes; empty for an include by macro
    bool quoted = false;
};

/// The #include lines of a source, those in comments and string literals apart.
std::vector<Include> includesOf(std::string_view source);

/// The lines of a source with comments, string and character literals blanked out; #include lines keep theirs.
std::vector<std::string> codeLinesOf(std::string_view source);

/// True where a line of code holds a word between characters that belong to no name.
bool holdsWord(std::string_view line, std::string_view word);

}  // namespace planewright::architecture
