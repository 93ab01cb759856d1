// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/laser.h"

#include <cmath>
#include <numbers>

namespace planewright {

double LaserLimits::bearing(int step) const
{
    return 0.5 * std::numbers::pi + (step - frontStep) * bearingStep();
}

double LaserLimits::bearingStep() const
{
    return 2.0 * std::numbers::pi / stepsPerTurn;
}

int LaserLimits::nearestStep(double bearing) const
{
    return frontStep + static_cast<int>(std::lround((bearing - 0.5 * std::numbers::pi) / bearingStep()));
}

}  // namespace planewright
