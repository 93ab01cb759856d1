// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace planewright {

/// Protocol 2.0 lets its header FF FF FD never appear inside a packet: there it is followed by one more FD. What is
/// stuffed is the instruction and the parameters; length and CRC count the bytes that were put in.
std::vector<std::uint8_t> stuffed(std::span<const std::uint8_t> content);

/// Takes the bytes out again that stuffed() put in.
std::vector<std::uint8_t> unstuffed(std::span<const std::uint8_t> content);

}  // namespace planewright
