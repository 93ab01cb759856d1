// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string_view>
#include <utility>
#include <vector>

#include "core/params/parameters.h"

namespace planewright {

/// A named set of values for some parameters.
struct Preset {
    std::string_view name;
    std::string_view meaning;
    std::vector<std::pair<std::string_view, std::string_view>> values;  ///< key and value, as -P takes them
};

/// The methods: `precise`, by maximum likelihood, and `paper`, the published method with its formulas corrected, whose
/// values are those of `Parameters{}`. The default is the first.
const std::vector<Preset>& methodPresets();

/// The scanners whose noise is known, by the name that --sensor takes.
const std::vector<Preset>& sensorPresets();

/// The preset of a name among these, or null.
const Preset* findPreset(const std::vector<Preset>& presets, std::string_view name);

/// The sensor preset for a recording's `scanner`, by a list of known names; null for an unknown name.
const Preset* sensorOfScanner(std::string_view scanner);

/// Sets the parameters that a built-in preset names.
void apply(const Preset& preset, Parameters& parameters);

}  // namespace planewright
