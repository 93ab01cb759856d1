// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

#include "core/formats/pwscan_notes.h"
#include "core/params/parameters_from.h"
#include "core/types/error.h"

namespace planewright {

/// The event that says so; its payload is a preset file with all parameters.
ScanEvent parametersEvent(int step, const Parameters& parameters);

/// The parameters that a scan was extracted with, by rising steps; events of other kinds are passed over. An event
/// takes the place of all before it that are for its step or later ones: after a scan was extracted once more, as a
/// whole, its parameters are the last for step 0. A parameter that an event does not name keeps its default. Errors
/// name the file: Unreadable for a payload that is no preset file or names a parameter that this program does not know.
Result<std::vector<ParametersFrom>> readParameterEvents(const std::vector<ScanEvent>& events,
                                                        const std::string& fileName);

}  // namespace planewright
