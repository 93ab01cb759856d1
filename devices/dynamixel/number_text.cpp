// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/dynamixel/number_text.h"

#include <array>
#include <charconv>

#include "core/types/angle.h"

namespace planewright {

std::string numberText(double value, int decimals)
{
    std::array<char, 400> text;  // the longest double in full
    const auto end =
        std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed, decimals).ptr;
    return {text.data(), end};
}

std::string angleText(double radians)
{
    return numberText(toDegrees(radians), 1) + " deg";
}

}  // namespace planewright
