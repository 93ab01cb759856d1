// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/formats/json_text.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <nlohmann/json.hpp>

#include "core/formats/number_text.h"
#include "core/params/registry.h"

namespace planewright {

void appendJsonText(std::string& json, std::string_view text)
{
    json += nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

void appendJsonNumber(std::string& json, double value)
{
    if (std::isfinite(value))
        appendNumber(json, value);
    else
        json += "null";
}

void appendJsonParameters(std::string& json, const Parameters& parameters)
{
    std::vector<std::string_view> keys;
    for (const ParameterRow& row : parameterRows())
        keys.push_back(row.key);
    appendJsonParameters(json, parameters, keys);
}

void appendJsonParameters(std::string& json, const Parameters& parameters, std::span<const std::string_view> keys)
{
    char before = '{';
    for (const ParameterRow& row : parameterRows()) {
        if (std::find(keys.begin(), keys.end(), row.key) == keys.end())
            continue;
        json += before;
        before = ',';
        appendJsonText(json, row.key);
        json += ':';
        const std::string value = printParameter(parameters, row.key);
        if (row.unit == Unit::Choice)
            appendJsonText(json, value);
        else
            json += value;
    }
    json += '}';
}

}  // namespace planewright
