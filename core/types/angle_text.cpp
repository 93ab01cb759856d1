// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/types/angle_text.h"

#include <array>
#include <charconv>
#include <cmath>

#include "core/types/angle.h"

namespace planewright {

std::string fixedText(double value, int decimals)
{
    std::array<char, 400> text;  // the longest double in full
    const auto end =
        std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed, decimals).ptr;
    std::string number{text.data(), end};
    if (number.starts_with('-') && number.find_first_not_of("-0.") == std::string::npos)
        number.erase(0, 1);
    return number;
}

std::string degreesText(double radians, int decimals)
{
    if (!(std::abs(radians) < 1e9))
        return "no angle";
    std::string digits = fixedText(toDegrees(radians), decimals);
    if (digits.find('.') != std::string::npos) {
        digits.erase(digits.find_last_not_of('0') + 1);
        if (digits.back() == '.')
            digits.pop_back();
    }
    return digits + "°";
}

}  // namespace planewright
