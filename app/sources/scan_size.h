// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

#include "devices/nodding/scan_plan.h"

namespace planewright {

/// "137 slices of 721 beams, 98,777 points, about 3.4 s": what a scan takes at least, before it begins.
std::string scanSizeText(const FittedPlan& plan, int slices);

}  // namespace planewright
