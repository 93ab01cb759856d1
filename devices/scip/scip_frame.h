// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <span>
#include <string_view>

#include <tl/expected.hpp>

#include "devices/scip/scip_event.h"

namespace planewright {

/// Reads the lines of a scan that come after its status: the stamp, and data in lines of 64 characters and their sum.
///
/// What passes is what was sent, unless two errors in one line outweigh each other: of 64 such lines one passes. Every
/// change of one character in a line is met, every line too few or too many, and every missing or added character.
tl::expected<ScipFrame, ScipDamageKind> readScipFrame(const ScipMeasurement& measurement,
                                                      std::span<const std::string_view> lines);

}  // namespace planewright
