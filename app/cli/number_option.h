// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <limits>
#include <string>

#include <CLI/CLI.hpp>

namespace planewright {

/// Options for numbers that do not depend on the locale and refuse anything else with the range allowed.
CLI::Option* addNumber(CLI::App& command, const std::string& name, double& value, double lowest, double highest,
                       const std::string& help);

/// The same for whole numbers. `Whole` is int, std::int64_t or std::uint64_t.
template <class Whole>
CLI::Option* addWholeNumber(CLI::App& command, const std::string& name, Whole& value, Whole lowest, Whole highest,
                            const std::string& help);

}  // namespace planewright
