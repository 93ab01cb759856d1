// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/sources/unit_tasks.h"

#include <utility>

#include "app/sources/unit_motion.h"
#include "core/types/angle_text.h"

namespace planewright {

Result<std::string> bringUnitHome(DeviceAccess& devices, const DeviceAddress& unit, const Clock& clock,
                                  const std::stop_token& stop)
{
    auto opened = devices.openTiltUnit(unit, stop);
    if (!opened)
        return tl::unexpected{opened.error()};
    UnitMotion motion(std::move(*opened), clock, stop);
    const Result<double> there = motion.goHome();
    if (!there)
        return tl::unexpected{there.error()};
    return motion.unit().identity() + " is held at " + degreesText(*there, 1);
}

Result<std::string> releaseUnit(DeviceAccess& devices, const DeviceAddress& unit, const std::stop_token& stop)
{
    const auto opened = devices.openTiltUnit(unit, stop);
    if (!opened)
        return tl::unexpected{opened.error()};
    if (const Result<void> released = (*opened)->recover(stop); !released)
        return tl::unexpected{released.error()};
    const std::string trouble = (*opened)->motor().trouble;
    return (*opened)->identity() + " is released" + (trouble.empty() ? "" : "; it says: " + trouble);
}

}  // namespace planewright
