// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/types/error.h"

namespace planewright {

using ExtraKeys = std::vector<std::pair<std::string, std::string>>;

/// Keys and values that a recording keeps without knowing them, as one JSON object in their order.
std::string extraJson(const ExtraKeys& extra);

/// The keys of such an object in their order; values that are no texts come as JSON. Keys that no header line can hold
/// are left out. Errors (Unreadable) begin with `place`.
Result<ExtraKeys> readExtraJson(std::string_view text, const std::string& place);

}  // namespace planewright
