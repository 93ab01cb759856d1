// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/dynamixel/byte_stuffing.h"

namespace planewright {

namespace {

bool endsLikeAHeader(const std::vector<std::uint8_t>& bytes)
{
    const std::size_t n = bytes.size();
    return n >= 3 && bytes[n - 3] == 0xFF && bytes[n - 2] == 0xFF && bytes[n - 1] == 0xFD;
}

}  // namespace

std::vector<std::uint8_t> stuffed(std::span<const std::uint8_t> content)
{
    std::vector<std::uint8_t> bytes;
    bytes.reserve(content.size());
    for (const std::uint8_t byte : content) {
        bytes.push_back(byte);
        if (endsLikeAHeader(bytes))
            bytes.push_back(0xFD);
    }
    return bytes;
}

std::vector<std::uint8_t> unstuffed(std::span<const std::uint8_t> content)
{
    std::vector<std::uint8_t> bytes;
    bytes.reserve(content.size());
    for (std::size_t i = 0; i < content.size(); ++i) {
        bytes.push_back(content[i]);
        if (endsLikeAHeader(bytes) && i + 1 < content.size() && content[i + 1] == 0xFD)
            ++i;
    }
    return bytes;
}

}  // namespace planewright
