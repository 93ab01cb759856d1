// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/formats/preset_file.h"

#include <istream>
#include <ostream>

#include <nlohmann/json.hpp>

#include "core/formats/json_text.h"
#include "core/formats/message_text.h"
#include "core/formats/number_text.h"
#include "core/formats/strict_json.h"
#include "core/formats/written.h"
#include "core/params/registry.h"

namespace planewright {

namespace {

/// A value as -P takes it.
Result<std::string> valueText(const std::string& key, const nlohmann::json& value)
{
    if (value.is_string())
        return value.get<std::string>();
    if (value.is_boolean())
        return std::string{value.get<bool>() ? "true" : "false"};
    if (!value.is_number())
        return fail(ErrorCode::Usage, "parameter " + key + ": a value is a number, a text, true or false; correct it");
    return exactNumber(value.get<double>());
}

}  // namespace

Result<void> readPresetFile(std::istream& in, const std::string& fileName, Parameters& parameters)
{
    const auto object = parseStrictJson(in, fileName);
    if (!object)
        return tl::unexpected(object.error());
    if (auto format = checkJsonFormat(*object, "planewright-preset", 1, fileName); !format)
        return format;
    const auto refuse = [&](ErrorCode code, const std::string& what) {
        return fail(code, placeInFile(fileName, 0) + what);
    };
    for (const auto& [key, value] : object->items()) {
        if (key != "format" && key != "parameters")
            return refuse(ErrorCode::Unreadable,
                          "the key " + quotedText(key) + " is not known; a preset has 'format' and 'parameters'");
    }
    if (!object->contains("parameters") || !(*object)["parameters"].is_object())
        return refuse(ErrorCode::Unreadable, "there is no object 'parameters'; add \"parameters\":{key:value}");

    Parameters changed = parameters;
    for (const auto& [key, value] : (*object)["parameters"].items()) {
        const auto text = valueText(quotedText(key), value);
        if (!text)
            return refuse(text.error().code, text.error().message);
        // No key or value that is right is changed by printableText, and messages repeat both.
        if (const auto set = setParameter(changed, printableText(key), printableText(*text)); !set)
            return refuse(set.error().code, set.error().message);
    }
    parameters = changed;
    return {};
}

Result<void> writePresetFile(std::ostream& out, const Parameters& parameters)
{
    std::string text = R"({"format":"planewright-preset 1","parameters":)";
    appendJsonParameters(text, parameters);
    out << text << "}\n";
    return written(out);
}

Result<void> writePresetFile(std::ostream& out, const Parameters& parameters, std::span<const std::string_view> keys)
{
    std::string text = R"({"format":"planewright-preset 1","parameters":)";
    appendJsonParameters(text, parameters, keys);
    out << text << "}\n";
    return written(out);
}

}  // namespace planewright
