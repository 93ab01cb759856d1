// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <stop_token>

#include "devices/scip/scip_clock.h"
#include "devices/scip/scip_connect.h"

namespace planewright {

/// Asks a laser at rest for its time, some times, and tells its clock the answers. The laser is off meanwhile, and out
/// of time mode afterwards. One that refuses, or stops answering, is left alone: its scans tell the time alone.
///
/// Errors: as for askScipPatiently().
Result<void> compareScipClocks(ScipLink& link, ScipVersion version, ScipClock& clock, const ScipProgress& progress,
                               const std::stop_token& stop);

}  // namespace planewright
