// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <iosfwd>
#include <span>
#include <string>
#include <string_view>

#include "core/params/parameters.h"
#include "core/types/error.h"

namespace planewright {

/// Sets the parameters that a preset or sensor file names: `{"format":"planewright-preset
/// 1","parameters":{key:value}}`, values as numbers, texts or switches in the unit that people see. On an error no
/// parameter has changed. Errors name file and key: Unreadable for what is no such JSON, Usage for an unknown parameter
/// or a value not allowed.
Result<void> readPresetFile(std::istream& in, const std::string& fileName, Parameters& parameters);

/// Writes all parameters as such a file; readPresetFile reads them back. Errors: NotWritten.
Result<void> writePresetFile(std::ostream& out, const Parameters& parameters);

/// The same with some parameters only, by their keys.
Result<void> writePresetFile(std::ostream& out, const Parameters& parameters, std::span<const std::string_view> keys);

}  // namespace planewright
