// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/common/preferences.h"

#include <algorithm>
#include <cmath>

namespace planewright {

namespace {

double within(double value, double lowest, double highest, double otherwise)
{
    return std::isfinite(value) ? std::clamp(value, lowest, highest) : otherwise;
}

}  // namespace

Preferences validated(Preferences preferences)
{
    const Preferences defaults;
    preferences.lengths.decimals = std::clamp(preferences.lengths.decimals, 0, kMostDecimals);
    preferences.pointBudget =
        within(preferences.pointBudget, kFewestPointsMoving, kMostPointsMoving, defaults.pointBudget);
    preferences.freeSpaceFloor = within(preferences.freeSpaceFloor, 0.0, 1000.0, defaults.freeSpaceFloor);
    if (preferences.preset.empty())
        preferences.preset = defaults.preset;
    return preferences;
}

}  // namespace planewright
