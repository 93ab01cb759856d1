// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string_view>

#include "app/cli/exit_code.h"
#include "app/cli/simulate_options.h"

namespace planewright {

inline constexpr std::string_view kBuildingScene = "building";
inline constexpr int kMostFloors = 50;
inline constexpr int kMostStops = 10'000;

/// Scans a building stop by stop into one `.pwscan`: each a scan with its floor and its pose by odometry.
Result<ExitCode> simulateBuilding(const SimulateOptions& options);

}  // namespace planewright
