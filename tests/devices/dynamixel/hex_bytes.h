// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <sstream>
#include <string>
#include <vector>

namespace planewright {

/// Bytes of "FF FF 01 02 01 FB".
inline std::vector<std::uint8_t> hexBytes(const std::string& text)
{
    std::vector<std::uint8_t> bytes;
    std::istringstream words{text};
    for (std::string word; words >> word;)
        bytes.push_back(static_cast<std::uint8_t>(std::stoul(word, nullptr, 16)));
    return bytes;
}

}  // namespace planewright
