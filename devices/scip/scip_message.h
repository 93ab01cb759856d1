// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <span>
#include <string_view>

#include <tl/expected.hpp>

#include "devices/scip/scip_event.h"

namespace planewright {

/// Reads the lines of one message, at least one, without line feeds and without the empty line that ends it: a reply or
/// a scan. A line that was too long to keep is given as an empty one.
///
/// A scan is refused where any line of data has not its length or not its sum, where a character is none of the
/// alphabet, or where there is not as much data as its own echo asks for. A reply of VV, PP or II with a wrong sum is
/// given, with that line marked: some lasers sum a line wrongly themselves. Of II, a sum that leaves out what comes
/// after "<-" is right too, as some firmware writes it.
tl::expected<ScipEvent, ScipDamageKind> readScipMessage(std::span<const std::string_view> lines);

/// True where a message may begin: an echo, and a status behind it.
bool beginsScipMessage(std::span<const std::string_view> lines);

}  // namespace planewright
