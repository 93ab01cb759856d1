// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/cli/angle_range.h"

#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

#include "core/types/angle.h"

namespace planewright {

namespace {

std::optional<std::array<double, 3>> threeNumbers(std::string_view text)
{
    std::array<double, 3> numbers{};
    const char* at = text.data();
    const char* const last = text.data() + text.size();
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        if (i > 0 && (at == last || *at++ != ':'))
            return std::nullopt;
        const auto [end, error] = std::from_chars(at, last, numbers[i]);
        if (error != std::errc{} || !std::isfinite(numbers[i]))
            return std::nullopt;
        at = end;
    }
    return at == last ? std::optional{numbers} : std::nullopt;
}

}  // namespace

Result<AngleRange> parseAngleRange(const std::string& option, const std::string& text, RangeEnd end,
                                   std::optional<int> most)
{
    const auto refuse = [&](const std::string& why) {
        return fail(ErrorCode::Usage, option + ": '" + text + "' " + why);
    };
    const auto numbers = threeNumbers(text);
    if (!numbers)
        return refuse("is not A:B:STEP in degrees, as in 10:170:1.16");
    const auto [first, last, step] = *numbers;
    if (std::abs(first) > 360.0 || std::abs(last) > 360.0)
        return refuse("goes beyond 360 degrees");
    if (step == 0.0 || (last - first) / step < 0.0)
        return refuse("never reaches its end; give a step that leads from A to B");
    if (!most)
        return AngleRange{degrees(first), degrees(step), 0};
    const double count = angleCount(first, last, step, end);
    if (count < 1.0)
        return refuse("holds no angle; give a smaller step");
    if (count > *most)
        return refuse("holds more than " + std::to_string(*most) + " angles; give a larger step");
    return AngleRange{degrees(first), degrees(step), static_cast<int>(count)};
}

}  // namespace planewright
