// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/formats/number_text.h"

#include <charconv>
#include <cmath>

namespace planewright {

void appendNumber(std::string& text, double value)
{
    if (!std::isfinite(value))
        return;
    char buffer[32];  // the longest is -1.23456789e-308
    const auto nine = std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::scientific, 8);
    double rounded = 0.0;
    std::from_chars(buffer, nine.ptr, rounded);
    rounded += 0.0;  // -0 becomes 0
    text.append(buffer, std::to_chars(buffer, buffer + sizeof buffer, rounded).ptr);
}

std::string formatNumber(double value)
{
    std::string text;
    appendNumber(text, value);
    return text;
}

std::string exactNumber(double value)
{
    char text[32];  // the longest is -1.7976931348623157e+308
    return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

}  // namespace planewright
