// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <stop_token>
#include <string>

#include "app/sources/device_access.h"
#include "devices/clock.h"

namespace planewright {

/// Opens a tilt unit, brings it home as UnitMotion::goHome() does, and closes it; gives what it is and where it is
/// held: "RX-64, number 1, firmware 24 is held at 90°". Errors: those of opening it and of UnitMotion.
Result<std::string> bringUnitHome(DeviceAccess& devices, const DeviceAddress& unit, const Clock& clock,
                                  const std::stop_token& stop);

/// Opens a tilt unit that has stopped by itself or in an emergency, and releases it, after a person has seen to the
/// cause; moves nothing. Gives what it is and how it is then. Never to be called unasked. Errors: those of opening it
/// and of TiltUnit::recover().
Result<std::string> releaseUnit(DeviceAccess& devices, const DeviceAddress& unit, const std::stop_token& stop);

}  // namespace planewright
