// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/sources/scan_size.h"

#include <charconv>
#include <cmath>

namespace planewright {

namespace {

/// A whole number with commas between thousands.
std::string grouped(std::int64_t number)
{
    std::string text = std::to_string(number);
    for (auto at = static_cast<std::ptrdiff_t>(text.size()) - 3; at > 0; at -= 3)
        text.insert(static_cast<std::size_t>(at), ",");
    return text;
}

/// Seconds with one digit, minutes above two of them.
std::string durationText(double seconds)
{
    constexpr double kTwoMinutes = 120.0;
    char text[64];
    const double shown = seconds < kTwoMinutes ? seconds : seconds / 60.0;
    const auto end = std::to_chars(text, text + sizeof text, shown, std::chars_format::fixed, 1);
    return std::string{text, end.ptr} + (seconds < kTwoMinutes ? " s" : " min");
}

}  // namespace

std::string scanSizeText(const FittedPlan& plan, int slices)
{
    return grouped(slices) + (slices == 1 ? " slice of " : " slices of ") + grouped(plan.beams) + " beams, " +
           grouped(std::llround(plan.points)) + " points, about " + durationText(plan.time.count());
}

}  // namespace planewright
