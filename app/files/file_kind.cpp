// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/files/file_kind.h"

#include <algorithm>

namespace planewright {

Result<std::string_view> suffixOf(const std::string& path, std::span<const std::string_view> known,
                                  std::string_view what)
{
    std::string lower = path;
    std::transform(lower.begin(), lower.end(), lower.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    for (const std::string_view suffix : known) {
        if (lower.size() > suffix.size() && lower.ends_with(suffix))
            return suffix;
    }
    std::string words;
    for (const std::string_view suffix : known)
        words += (words.empty() ? "" : ", ") + std::string{suffix};
    return fail(ErrorCode::Usage, path + ": the name of " + std::string{what} + " tells its kind; known are " + words);
}

}  // namespace planewright
