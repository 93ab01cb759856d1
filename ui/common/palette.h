// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "core/types/plane.h"

namespace planewright {

/// An opaque colour, sRGB.
struct Rgb {
    std::uint8_t red = 0;
    std::uint8_t green = 0;
    std::uint8_t blue = 0;

    friend bool operator==(const Rgb&, const Rgb&) = default;
};

/// The sets of colours that planes may have.
enum class PlanePalette { Normal, ColourBlind, HighContrast };
inline constexpr std::array<std::string_view, 3> kPlanePaletteNames{"normal", "colour-blind", "high contrast"};

/// The background that colours stand on.
enum class Theme { Light, Dark };

/// How many planes in a row of ids differ in colour.
inline constexpr int kPlaneColours = 32;

/// The colour that a plane keeps for life: twelve hues that also differ for the colour-blind, then steps of lightness.
Rgb planeColour(PlaneId id, PlanePalette palette, Theme theme);

/// The colours of whatever is no plane.
struct ThemeColours {
    Rgb background;     ///< of the 3D view
    Rgb backgroundTop;  ///< what it shades into
    Rgb grid;
    Rgb text;
    Rgb unfitted;   ///< points and segments that belong to no plane
    Rgb sensor;     ///< the scanner and the fan of the current slice
    Rgb selection;  ///< the outer of the two lines around a selection
    Rgb selectionInner;
};
const ThemeColours& themeColours(Theme theme);

/// Contrast between two colours by WCAG 2: 1 to 21.
double contrast(Rgb a, Rgb b);

}  // namespace planewright
