// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <string_view>

namespace planewright {

// Sides that a picture may have [pixels]; the largest is 8K.
inline constexpr int kFewestPixels = 16;
inline constexpr int kMostPixels = 8192;

struct PictureSize {
    int width = 1280;
    int height = 800;
};

/// Reads `1280x800`; none where it is no size, or a side is out of limits.
std::optional<PictureSize> readPictureSize(std::string_view text);

}  // namespace planewright
