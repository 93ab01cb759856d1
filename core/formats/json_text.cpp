// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/formats/json_text.h"

#include <cmath>

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
    char before = '{';
    for (const ParameterRow& row : parameterRows()) {
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
