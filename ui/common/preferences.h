// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "ui/common/length_style.h"
#include "ui/common/palette.h"

namespace planewright {

/// Which colours the window has.
enum class ThemeChoice { System, Light, Dark };

/// What draws the 3D view.
enum class Renderer { Automatic, Gpu, Software };

/// What is written to the log.
enum class LogDetail { Problems, Everything };

inline constexpr double kFewestPointsMoving = 10.0;     // [thousand]
inline constexpr double kMostPointsMoving = 100'000.0;  // [thousand]

/// What the user has chosen once and for all, as one value. Its defaults are those of a first start.
struct Preferences {
    // General
    ThemeChoice theme = ThemeChoice::System;
    LengthStyle lengths;

    // View
    Renderer renderer = Renderer::Automatic;
    double pointBudget = 50.0;  ///< points drawn while the view moves [thousand]
    bool antiAliasing = true;   ///< on a graphics card; in software it would take twice the time
    PlanePalette palette = PlanePalette::Normal;

    // Scan
    std::string recordFolder;     ///< empty: the folder for documents
    double freeSpaceFloor = 1.0;  ///< below this free space no recording begins [GB], 0 to 1000
    std::string preset = "precise";
    bool alarmSound = true;

    // Shortcuts: of actions by object name, where they are not the program's own
    std::map<std::string, std::vector<std::string>> shortcuts;

    // Advanced
    LogDetail logDetail = LogDetail::Everything;
    bool safeModeNextStart = false;

    friend bool operator==(const Preferences&, const Preferences&) = default;
};

/// Numbers brought into their limits.
Preferences validated(Preferences preferences);

}  // namespace planewright
