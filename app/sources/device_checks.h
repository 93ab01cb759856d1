// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>

#include "app/sources/device_access.h"
#include "app/sources/open_source.h"

namespace planewright {

/// The checks that a test of the devices makes, in order.
inline constexpr std::array<std::string_view, 6> kDeviceChecks{"Permission", "Laser answers", "Tilt unit answers",
                                                               "Plan fits",  "One slice",     "5° move and back"};

/// Told that a check begins (nothing), or how it went.
using DeviceCheckProgress = std::function<void(std::size_t check, const std::optional<Result<std::string>>& result)>;

/// Looks whether a laser and a tilt unit can scan: opens both, takes a turn of the mirror, and moves the head by 5° and
/// back to where it was. Ends with the first check that fails, and closes both. Nothing moves before the last check.
///
/// A stop holds the head at once, in the thread of whoever asks for it, and fails the check that runs.
void checkDevices(DeviceAccess& devices, const std::string& laser, const NoddingSetup& setup, const Clock& clock,
                  const DeviceCheckProgress& progress, const std::stop_token& stop);

}  // namespace planewright
