// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

#include <nlohmann/json.hpp>

namespace planewright {

using Json = nlohmann::ordered_json;

/// JSON as it goes to standard output; bytes that are no UTF-8, as in foreign file names, are replaced.
std::string jsonText(const Json& json);

/// One value as people read it: numbers in their shortest form, yes and no, texts without quotes.
std::string valueText(const Json& value);

}  // namespace planewright
