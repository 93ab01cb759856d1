// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

#include <nlohmann/json.hpp>

namespace planewright {

using Json = nlohmann::ordered_json;

/// JSON as it goes to standard output; bytes that are no UTF-8, as in foreign file names, are replaced.
inline std::string jsonText(const Json& json)
{
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace planewright
