// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/formats/scan_extra.h"

#include <algorithm>
#include <array>
#include <sstream>

#include <nlohmann/json.hpp>

#include "core/formats/json_text.h"
#include "core/formats/message_text.h"
#include "core/formats/number_cells.h"
#include "core/formats/strict_json.h"

namespace planewright {

namespace {

using nlohmann::json;

constexpr std::size_t kMostKeys = 1000;

/// Hears the keys of the outermost object in the order of the text, which the parsed value does not keep.
class KeyOrder : public nlohmann::json_sax<json> {
public:
    bool null() override { return true; }
    bool boolean(bool) override { return true; }
    bool number_integer(number_integer_t) override { return true; }
    bool number_unsigned(number_unsigned_t) override { return true; }
    bool number_float(number_float_t, const string_t&) override { return true; }
    bool string(string_t&) override { return true; }
    bool binary(binary_t&) override { return true; }
    bool start_object(std::size_t) override { return ++depth_ > 0; }
    bool end_object() override { return --depth_ >= 0; }
    bool start_array(std::size_t) override { return ++depth_ > 0; }
    bool end_array() override { return --depth_ >= 0; }
    bool key(string_t& key) override
    {
        if (depth_ == 1)
            keys.push_back(key);
        return true;
    }
    bool parse_error(std::size_t, const std::string&, const json::exception&) override { return false; }

    std::vector<std::string> keys;

private:
    int depth_ = 0;
};

/// Header lines are `# key = value`, and these keys mean something there.
bool fitsHeader(std::string_view key)
{
    static constexpr std::array<std::string_view, 8> kKnown{
        "format",      "scanner",          "bearing_start_deg", "beams",
        "range_min_m", "bearing_step_deg", "range_max_m",       "pitch_axis_offset_m"};
    return !key.empty() && isPlainUtf8(key) && trimmed(key) == key && key.find('=') == std::string_view::npos &&
           std::find(kKnown.begin(), kKnown.end(), key) == kKnown.end();
}

}  // namespace

std::string extraJson(const ExtraKeys& extra)
{
    std::string text = "{";
    for (const auto& [key, value] : extra) {
        text += text.size() > 1 ? "," : "";
        appendJsonText(text, key);
        text += ':';
        appendJsonText(text, value);
    }
    return text + '}';
}

Result<ExtraKeys> readExtraJson(std::string_view text, const std::string& place)
{
    std::istringstream in{std::string{text}};
    const auto object = parseStrictJson(in, place);
    if (!object)
        return tl::unexpected{object.error()};
    KeyOrder order;
    if (!object->is_object() || object->size() > kMostKeys || !json::sax_parse(text, &order))
        return fail(ErrorCode::Unreadable,
                    place + ": this is no JSON object of at most " + std::to_string(kMostKeys) + " keys; correct it");
    ExtraKeys extra;
    for (const std::string& key : order.keys) {
        if (!fitsHeader(key))
            continue;
        const json& value = (*object)[key];
        extra.emplace_back(key, value.is_string() ? value.get<std::string>()
                                                  : value.dump(-1, ' ', false, json::error_handler_t::replace));
    }
    return extra;
}

}  // namespace planewright
