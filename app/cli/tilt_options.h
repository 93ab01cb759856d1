// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

#include "core/simulation/acquisition_settings.h"
#include "core/types/error.h"

namespace planewright {

/// Takes over --tilt (A:B:STEP, empty: as it is) and --slices (0: as --tilt says). Errors (Usage): what parseAngleRange
/// says, or a last slice that tilts beyond ±360°.
Result<void> takeTilt(const std::string& tilt, int slices, AcquisitionSettings& settings);

}  // namespace planewright
