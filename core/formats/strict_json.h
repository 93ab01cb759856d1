// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <istream>
#include <string>

#include <nlohmann/json.hpp>

#include "core/types/error.h"

namespace planewright {

/// Limits of a foreign JSON file: its bytes, how deep it nests, and how many values it holds.
inline constexpr std::size_t kMaxJsonBytes = std::size_t{64} << 20;
inline constexpr std::size_t kMaxJsonDepth = 64;
inline constexpr std::size_t kMaxJsonValues = 4'000'000;

/// Reads a whole stream as one JSON value, within the limits, without a key twice in an object and without numbers that
/// are not finite. Errors (Unreadable) name file, line and column, or the key.
Result<nlohmann::json> parseStrictJson(std::istream& in, const std::string& fileName);

/// Holds `format` of a JSON object against the one that is wanted, `name version`. Errors (Unreadable): another format,
/// or a newer version of this one.
Result<void> checkJsonFormat(const nlohmann::json& object, std::string_view name, int version,
                             const std::string& fileName);

}  // namespace planewright
