// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <string_view>
#include <vector>

namespace planewright {

/// The words of a text, separated by blanks and tabulators: the first `most` and, where there are more, one more.
inline std::vector<std::string_view> wordsIn(std::string_view text, std::size_t most)
{
    std::vector<std::string_view> words;
    while (words.size() <= most) {
        const std::size_t first = text.find_first_not_of(" \t");
        if (first == std::string_view::npos)
            break;
        text.remove_prefix(first);
        const std::size_t end = std::min(text.find_first_of(" \t"), text.size());
        words.push_back(text.substr(0, end));
        text.remove_prefix(end);
    }
    return words;
}

}  // namespace planewright
