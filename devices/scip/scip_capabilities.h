// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>

#include "devices/laser.h"

namespace planewright {

/// What may be asked of a laser. Known by its product, firmware and protocol, never found out by trying: some lasers
/// hang after a command that they do not know, until their power is switched off.
struct ScipCapabilities {
    /// With intensities, the widest angle of a scan that does not crash it, times the cluster [rad]; empty: any.
    std::optional<double> widestIntensity;
    bool timeMode = false;    ///< TM: its clock may be asked, and tells the truth
    bool lineSpeed = false;   ///< SS
    bool motorSpeed = false;  ///< CR
    bool reboot = false;      ///< RB
    bool multiEcho = false;   ///< ND, NE, HD, HE
};

ScipCapabilities scipCapabilities(const LaserIdentity& identity);

}  // namespace planewright
