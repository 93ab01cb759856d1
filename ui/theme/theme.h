// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <QPalette>

#include "ui/common/palette.h"

namespace planewright {

/// The colours of the window's controls: text on every background has a contrast of 4.5 at least.
QPalette applicationPalette(Theme theme);

/// Gives the program its look: the colours, and a style with clear focus and targets of 28 pixels. May be called again
/// whenever the theme changes.
void applyTheme(Theme theme);

/// Which theme a palette belongs to, by its background.
Theme themeOf(const QPalette& palette);

}  // namespace planewright
