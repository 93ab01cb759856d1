// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <chrono>
#include <string>
#include <vector>

#include "devices/laser.h"
#include "devices/scan_source.h"
#include "devices/tilt_unit.h"

namespace planewright {

/// What a device panel shows of a nodding scanner.
struct NoddingHealth {
    LinkHealth laser;
    LinkHealth tilt;
    MotorState motor;
    std::string trouble;                      ///< empty, or what is wrong between scans
    std::chrono::nanoseconds largestSkew{0};  ///< farthest in time of an angle from a beam that it was used for
    double pitchStep = 0.0;                   ///< from slice to slice, as the unit really does it [rad]
    int slicesLost = 0;                       ///< of this scan, that were passed over for good
};

/// "load 6 %, 14.8 V, 38 °C": what is known of it.
std::string motorText(const MotorState& motor);

/// A panel's health in words, with how often each kind of fault was seen; those that a single line shows among them:
/// rates, what was lost, corrupt or late, load, voltage and temperature, and troubles in front.
std::vector<HealthFact> factsOf(const NoddingHealth& health);

}  // namespace planewright
