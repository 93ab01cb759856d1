// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <map>
#include <string>
#include <string_view>

#include "tests/architecture/offence.h"

namespace planewright::architecture {

/// Holds the includes and the words of one source file against the rooms of the house.
///
/// `path` is from the top of the source tree, with '/'. Paths outside app, core, devices and ui break no rule.
Offences checkSource(std::string_view path, std::string_view source);

/// Finds headers that include each other in a circle. `sources` maps paths from the top to texts; each circle is
/// named once.
Offences checkCircles(const std::map<std::string, std::string>& sources);

}  // namespace planewright::architecture
