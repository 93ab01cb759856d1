// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

#include "app/session/scan_history.h"
#include "core/params/parameters_from.h"

namespace planewright {

/// What a recording was extracted with, or else the default method with the noise of the scanner.
std::vector<ParametersFrom> defaultParameters(const std::string& scanner, std::vector<ParametersFrom> stored);

/// What a scan was extracted with: the first from step 0 on, each other from the step on at which it came.
std::vector<ParametersFrom> parametersOf(const ScanHistory& history);

}  // namespace planewright
