// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/window/picture_size.h"

#include <charconv>

namespace planewright {

std::optional<PictureSize> readPictureSize(std::string_view text)
{
    const std::size_t cross = text.find('x');
    if (cross == std::string_view::npos)
        return std::nullopt;
    const auto side = [](std::string_view part, int& value) {
        const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), value);
        return error == std::errc{} && end == part.data() + part.size() && value >= kFewestPixels &&
               value <= kMostPixels;
    };
    PictureSize size;
    if (!side(text.substr(0, cross), size.width) || !side(text.substr(cross + 1), size.height))
        return std::nullopt;
    return size;
}

}  // namespace planewright
