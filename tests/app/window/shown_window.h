// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <chrono>
#include <memory>

#include "app/window/window_controllers.h"
#include "app/window/window_parts.h"
#include "ui/theme/theme_follower.h"

namespace planewright {

/// How long a test waits for the program at most.
inline constexpr std::chrono::seconds kPatience{120};

/// The program's window with all that belongs to it, on the screen that there is.
class ShownWindow {
public:
    /// Settings are written to the file. Errors: there is nothing to draw the view with.
    static Result<std::unique_ptr<ShownWindow>> open(const QString& settingsFile);
    ~ShownWindow();

    /// Scans the corridor with seed 7 as fast as possible, to its end; false if that fails.
    bool scanCorridor();
    QAction* action(const char* name) { return parts.window->actions()[QLatin1String(name)]; }

    ThemeFollower follower;
    WindowParts parts;
    std::unique_ptr<WindowControllers> controllers;

private:
    explicit ShownWindow(const QString& settingsFile);
};

/// Fonts and numbers that are the same on every machine; before the first window.
void useFixedLook();

}  // namespace planewright
