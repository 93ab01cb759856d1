// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "tests/architecture/offence.h"

namespace planewright::architecture {

/// Holds the names at the top level against the agreed layout: nothing else may lie there, nothing may be missing.
/// `ignored` are the lines of .gitignore: what a build or the demo leaves behind breaks no rule.
Offences checkTopLevel(const std::vector<std::string>& names, const std::vector<std::string>& ignored);

/// True for a file that must carry the two SPDX lines: sources, scripts, CMake files and package lists.
bool needsLicenceLines(std::string_view path, std::string_view text);

/// The two SPDX lines stand first in a file, after the line that names a script's interpreter.
Offences checkLicenceLines(std::string_view path, std::string_view text);

/// A source file has at most 400 lines, a test 600: facts about one subject are listed, not nested.
Offences checkLength(std::string_view path, std::string_view text);

}  // namespace planewright::architecture
