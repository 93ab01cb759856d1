// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/common/palette.h"

#include <algorithm>
#include <cmath>

namespace planewright {

namespace {

using Hues = std::array<Rgb, 12>;

// Ordered so that neighbours differ in lightness and in hue.
constexpr Hues kNormal{{{31, 119, 180},
                        {230, 120, 20},
                        {34, 139, 64},
                        {200, 40, 60},
                        {125, 85, 190},
                        {0, 150, 160},
                        {205, 80, 160},
                        {135, 130, 20},
                        {140, 85, 60},
                        {80, 110, 230},
                        {100, 155, 40},
                        {165, 60, 120}}};
// The colours of Okabe and Ito (2008) and of Tol's muted scheme, without black and the palest.
constexpr Hues kColourBlind{{{0, 114, 178},
                             {213, 94, 0},
                             {0, 158, 115},
                             {204, 121, 167},
                             {86, 180, 233},
                             {180, 130, 0},
                             {136, 34, 85},
                             {51, 34, 136},
                             {17, 119, 51},
                             {204, 102, 119},
                             {68, 170, 153},
                             {153, 153, 51}}};
constexpr Hues kHighContrast{{{0, 80, 255},
                              {215, 90, 0},
                              {0, 130, 30},
                              {215, 0, 40},
                              {130, 40, 220},
                              {0, 135, 150},
                              {215, 0, 170},
                              {120, 110, 0},
                              {150, 70, 20},
                              {60, 60, 160},
                              {70, 130, 0},
                              {160, 0, 90}}};

/// Moves a colour towards another by a share of 0 to 1.
Rgb mixed(Rgb colour, Rgb other, double share)
{
    const auto mix = [share](std::uint8_t a, std::uint8_t b) {
        return static_cast<std::uint8_t>(std::lround((1.0 - share) * a + share * b));
    };
    return {mix(colour.red, other.red), mix(colour.green, other.green), mix(colour.blue, other.blue)};
}

double luminance(Rgb colour)
{
    const auto linear = [](std::uint8_t channel) {
        const double value = channel / 255.0;
        return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(colour.red) + 0.7152 * linear(colour.green) + 0.0722 * linear(colour.blue);
}

}  // namespace

Rgb planeColour(PlaneId id, PlanePalette palette, Theme theme)
{
    constexpr Rgb kBlack{0, 0, 0};
    constexpr Rgb kWhite{255, 255, 255};
    const Hues& hues = palette == PlanePalette::ColourBlind    ? kColourBlind
                       : palette == PlanePalette::HighContrast ? kHighContrast
                                                               : kNormal;
    const auto place = static_cast<std::size_t>(std::max(id, 0) % kPlaneColours);
    const Rgb hue = hues[place % hues.size()];
    const std::size_t round = place / hues.size();
    const Rgb stepped = round == 0 ? hue : round == 1 ? mixed(hue, kBlack, 0.35) : mixed(hue, kWhite, 0.3);
    return theme == Theme::Dark ? mixed(stepped, kWhite, 0.25) : stepped;
}

const ThemeColours& themeColours(Theme theme)
{
    static const ThemeColours light{.background = {244, 245, 247},
                                    .backgroundTop = {222, 227, 234},
                                    .grid = {176, 182, 190},
                                    .text = {32, 36, 42},
                                    .unfitted = {120, 124, 130},
                                    .sensor = {200, 60, 30},
                                    .selection = {0, 0, 0},
                                    .selectionInner = {255, 255, 255}};
    static const ThemeColours dark{.background = {30, 33, 38},
                                   .backgroundTop = {44, 48, 56},
                                   .grid = {84, 90, 100},
                                   .text = {232, 234, 238},
                                   .unfitted = {150, 154, 160},
                                   .sensor = {255, 130, 90},
                                   .selection = {255, 255, 255},
                                   .selectionInner = {0, 0, 0}};
    return theme == Theme::Dark ? dark : light;
}

double contrast(Rgb a, Rgb b)
{
    const double first = luminance(a);
    const double second = luminance(b);
    return (std::max(first, second) + 0.05) / (std::min(first, second) + 0.05);
}

}  // namespace planewright
