// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/board/cobs.h"

#include <algorithm>

namespace planewright::board {

namespace {

/// A block of this length says nothing about a 0x00 after it.
constexpr std::size_t kFullBlock = 0xFF;

}  // namespace

std::vector<std::uint8_t> encodeCobs(std::span<const std::uint8_t> bytes)
{
    std::vector<std::uint8_t> stuffed{0};
    std::size_t block = 0;  // where the length of the present block goes
    const auto endBlock = [&] {
        stuffed[block] = static_cast<std::uint8_t>(stuffed.size() - block);
        block = stuffed.size();
        stuffed.push_back(0);
    };
    for (const std::uint8_t byte : bytes) {
        if (stuffed.size() - block == kFullBlock)
            endBlock();
        if (byte == 0)
            endBlock();
        else
            stuffed.push_back(byte);
    }
    stuffed[block] = static_cast<std::uint8_t>(stuffed.size() - block);
    return stuffed;
}

std::optional<std::vector<std::uint8_t>> decodeCobs(std::span<const std::uint8_t> bytes)
{
    std::vector<std::uint8_t> plain;
    if (bytes.empty() || std::find(bytes.begin(), bytes.end(), std::uint8_t{0}) != bytes.end())
        return std::nullopt;
    while (!bytes.empty()) {
        const std::size_t length = bytes[0];
        if (length > bytes.size())
            return std::nullopt;
        plain.insert(plain.end(), bytes.begin() + 1, bytes.begin() + static_cast<std::ptrdiff_t>(length));
        bytes = bytes.subspan(length);
        if (length != kFullBlock && !bytes.empty())
            plain.push_back(0);
    }
    return plain;
}

}  // namespace planewright::board
