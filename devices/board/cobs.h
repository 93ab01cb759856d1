// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace planewright::board {

/// Consistent overhead byte stuffing (Cheshire and Baker 1999): the same bytes without any 0x00, which is then free to
/// end a frame. One byte longer, and one more for every 254 bytes without a 0x00.
std::vector<std::uint8_t> encodeCobs(std::span<const std::uint8_t> bytes);

/// The bytes before stuffing; empty where these cannot have come from it: a 0x00 among them, or a block that is cut.
std::optional<std::vector<std::uint8_t>> decodeCobs(std::span<const std::uint8_t> bytes);

}  // namespace planewright::board
