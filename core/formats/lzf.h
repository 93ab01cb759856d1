// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace planewright {

/// So many bytes one of LZF can make at most: 264 of 3.
inline constexpr std::size_t kMostLzfGrowth = 88;

/// Decompresses LZF, which binary_compressed .pcd files hold. True where it gives exactly `size` bytes and uses all of
/// its own.
///
/// The format: a byte below 32 is followed by one more plain bytes than it says; else its three high bits, and the next
/// byte where they are all set, are two less than the length of a copy, and its five low ones and the byte after, the
/// distance back less one.
bool decompressLzf(std::string_view compressed, std::size_t size, std::string& plain);

}  // namespace planewright
