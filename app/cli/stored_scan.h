// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

#include "app/cli/parameter_options.h"
#include "app/files/recording_file.h"
#include "app/files/scan_results.h"
#include "core/formats/parameter_events.h"
#include "core/types/error.h"

namespace planewright {

/// What a scan was extracted with while it ran, up to a step (all where it is negative), as far as the command line
/// does not say otherwise. Errors as parametersInForce.
Result<std::vector<ParametersFrom>> parametersOverSteps(const RecordingFile& input, const std::string& scanner,
                                                        const std::string& path, int until,
                                                        const ParameterOptions& options);

/// Makes the planes what the operator sees: with the edits of the file, unless `noEdits`. An edit that cannot be
/// applied is told as a warning.
void applyStoredEdits(ScanResults& extraction, const RecordingFile& input, bool noEdits, const std::string& path);

}  // namespace planewright
