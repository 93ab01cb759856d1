// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/types/snapshot.h"
#include "ui/common/chart.h"

namespace planewright {

/// What a step should take at most, and must take no longer than while a scanner runs [ms].
inline constexpr double kStepGoal = 10.0;
inline constexpr double kStepLimit = 25.0;

/// The charts of a scan, by the reports of its steps: fitted segments, unfitted segments, planes and mean error
/// (Fig. 15 of the paper), time of the phases (Fig. 17) and their averages (Fig. 18), time against segments (Fig. 14).
///
/// The mean error has a gap where there is no plane, and a line at its limit, or without one at 1, which is expected.
/// Always all seven, those of a scan without steps without numbers. The forced last pass is no step and in none of
/// them. Averages are over the steps at which a phase ran. Takes time in proportion to the steps.
std::vector<Chart> scanCharts(const std::vector<std::shared_ptr<const Snapshot>>& history,
                              std::optional<double> errorLimit);

}  // namespace planewright
