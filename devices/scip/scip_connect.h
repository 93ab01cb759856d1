// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <stop_token>
#include <string>

#include "devices/laser.h"
#include "devices/scip/scip_capabilities.h"
#include "devices/scip/scip_link.h"
#include "devices/scip/scip_patience.h"
#include "devices/scip/scip_status.h"

namespace planewright {

/// Who is at the end of a link.
struct ScipPartner {
    LaserIdentity identity;
    LaserLimits limits;
    ScipCapabilities able;
    ScipVersion version = ScipVersion::V2_0;
    std::string warning;  ///< empty, or what it says of its own condition in words that are not known
};

/// Brings a laser to rest from whatever it does, and asks who it is.
///
/// It may be streaming, be in time mode, speak SCIP 1.1, be starting up, or be faulty; half a request or half a scan
/// may be on the line. One that says that it is faulty is reset once, and started anew where its model can.
///
/// Errors (NoDevice): nothing answers, something that is no laser does, or the laser is faulty or too old, each with
/// what to do; DeviceLost: those of the transport; Interrupted: a stop.
Result<ScipPartner> connectScip(ScipLink& link, const ScipProgress& progress, const std::stop_token& stop);

/// Starts a laser anew whose model can (ScipCapabilities::reboot), and waits until it is at rest. Errors: as above.
Result<void> restartScip(ScipLink& link, const ScipProgress& progress, const std::stop_token& stop);

}  // namespace planewright
