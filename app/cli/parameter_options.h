// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <CLI/CLI.hpp>

#include "core/formats/parameter_events.h"
#include "core/params/mapping_parameters.h"
#include "core/params/parameters.h"
#include "core/params/presets.h"
#include "core/types/error.h"

namespace planewright {

/// What the command line says about parameters.
struct ParameterOptions {
    std::string preset;  ///< empty: what the recording was extracted with, or else the default
    std::string sensor;  ///< empty: by the recording's scanner
    std::vector<std::string> assignments;
};

/// Adds --preset, --sensor and -P.
void addParameterOptions(CLI::App& command, ParameterOptions& options);

/// The parameters in force: the preset, then the sensor, then each -P; the later wins. Without --sensor the recording's
/// scanner chooses by a list of known names; an unknown name warns on stderr. A preset or sensor is a built-in name, a
/// file of the user's own presets ($XDG_CONFIG_HOME/planewright/presets/NAME.json), or the path of a file; a file of
/// the method changes the default preset. Errors: Usage for an unknown name, key or value; Unreadable for a broken
/// file.
Result<Parameters> parametersInForce(const ParameterOptions& options, std::string_view scanner);

/// The same for a recording that has parameters stored with it, step by step: without --preset these take the place of
/// preset and sensor, and --sensor and -P change each of them. One set of parameters at least.
Result<std::vector<ParametersFrom>> parametersInForce(const ParameterOptions& options, std::string_view scanner,
                                                      std::vector<ParametersFrom> stored);

/// What -P says of maps of several stops; the options then hold the rest. Errors: Usage for an unknown key or value.
Result<MappingParameters> takeMappingParameters(ParameterOptions& options);

}  // namespace planewright
