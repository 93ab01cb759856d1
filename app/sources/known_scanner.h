// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "devices/laser.h"
#include "devices/nodding/scan_plan.h"

namespace planewright {

/// What devices that were opened have said of themselves: enough to tell what a scan with them takes.
struct KnownScanner {
    LaserLimits laser;
    double lowest = 0.0;      ///< φ that the tilt unit can and may take [rad]
    double highest = 0.0;     ///< [rad]
    double fastest = 0.0;     ///< [rad/s]
    double resolution = 0.0;  ///< its smallest step [rad]
    double speedStep = 0.0;   ///< of which its speeds are multiples [rad/s]; 0: it has any
};

/// Takes over what a unit says.
void note(const TiltUnit& unit, KnownScanner& scanner);

/// Fits a plan to devices that need not be there any more. Errors: those of fitPlan().
Result<FittedPlan> fitPlanTo(const KnownScanner& scanner, const ScanPlan& plan);

}  // namespace planewright
