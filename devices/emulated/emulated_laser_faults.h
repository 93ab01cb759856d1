// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <span>
#include <string>
#include <string_view>

#include "core/simulation/random.h"
#include "core/types/error.h"
#include "devices/emulated/emulated_device.h"

namespace planewright {

/// A fault that an emulated laser can have.
struct LaserFaultKind {
    std::string_view name;      ///< KIND of KIND@STEP
    std::string_view sentence;  ///< what happens
    /// What it begins with.
    enum class Strikes {
        Connection,  ///< the laser is so when it is first spoken to, whatever the step
        Scan,        ///< the scan of its step, by something that the laser does
        Bytes,       ///< the bytes of that scan: damageScan()
    };
    Strikes strikes;
};

std::span<const LaserFaultKind> laserFaultKinds();

/// Errors (Usage): no kind of that name, with all that there are; a step below 0.
Result<void> checkLaserFault(const FaultAt& fault);

/// A scan's bytes as they come where a fault of bytes strikes them. `reply` is what laser-interleave puts into the
/// scan.
std::string damageScan(std::string_view kind, std::string bytes, const std::string& reply, Random& random);

}  // namespace planewright
