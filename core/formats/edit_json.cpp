// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/formats/edit_json.h"

#include <algorithm>
#include <array>
#include <limits>
#include <sstream>

#include <nlohmann/json.hpp>

#include "core/formats/json_text.h"
#include "core/formats/message_text.h"
#include "core/formats/number_cells.h"
#include "core/formats/strict_json.h"

namespace planewright {

namespace {

constexpr std::array<std::string_view, 7> kKinds{"rename", "classify", "hide", "delete", "merge", "split", "lock"};
constexpr std::size_t kMostPlanes = 10'000;
constexpr std::size_t kMostPayloadBytes = std::size_t{1} << 20;
constexpr int kMostCharacters = 120;

bool hasText(Edit::Kind kind)
{
    return kind == Edit::Kind::Rename || kind == Edit::Kind::Classify;
}

bool canBeTurnedOff(Edit::Kind kind)
{
    return kind == Edit::Kind::Hide || kind == Edit::Kind::Lock;
}

std::string readPlanes(const nlohmann::json& planes, Edit& edit)
{
    if (!planes.is_array() || planes.empty() || planes.size() > kMostPlanes)
        return "'planes' is no list of 1 to " + std::to_string(kMostPlanes) + " plane numbers";
    for (const auto& plane : planes) {
        if (!plane.is_number_unsigned() ||
            plane.get<std::uint64_t>() > static_cast<std::uint64_t>(std::numeric_limits<PlaneId>::max()))
            return "'planes' holds something that is no plane number";
        const auto id = plane.get<PlaneId>();
        if (std::find(edit.planes.begin(), edit.planes.end(), id) != edit.planes.end())
            return "'planes' names plane " + std::to_string(id) + " twice";
        edit.planes.push_back(id);
    }
    if (edit.kind == Edit::Kind::Merge ? edit.planes.size() < 2
                                       : edit.kind == Edit::Kind::Split && edit.planes.size() > 1)
        return edit.kind == Edit::Kind::Merge ? "a merge needs two planes" : "a split takes one plane";
    return {};
}

/// Marks that turn the direction of writing (UAX 9), and those that split lines.
bool isHiddenMark(char32_t code)
{
    return code == 0x061C || (code >= 0x200E && code <= 0x200F) || (code >= 0x2028 && code <= 0x202E) ||
           (code >= 0x2066 && code <= 0x2069) || code == 0xFEFF;
}

/// The bytes of the character at the beginning of a text; 0 where it is none of UTF-8.
std::size_t characterAt(std::string_view text, char32_t& code)
{
    const auto lead = static_cast<unsigned char>(text.front());
    const std::size_t size = lead < 0x80 ? 1 : lead < 0xE0 ? 2 : lead < 0xF0 ? 3 : 4;
    if (size > text.size() || !isPlainUtf8(text.substr(0, size)))
        return 0;
    code = size == 1 ? lead : lead & (0x7FU >> size);
    for (std::size_t i = 1; i < size; ++i)
        code = code << 6 | (static_cast<unsigned char>(text[i]) & 0x3FU);
    return size;
}

}  // namespace

std::string_view name(Edit::Kind kind)
{
    return kKinds[static_cast<std::size_t>(kind)];
}

std::string cleanName(std::string_view text)
{
    std::string clean;
    int characters = 0;
    while (!text.empty() && characters < kMostCharacters) {
        char32_t code = 0;
        const std::size_t size = characterAt(text, code);
        // What is between two words, a line end too, parts them still.
        const bool blank = text.front() == ' ' || (text.front() >= '\t' && text.front() <= '\r');
        if (blank && !clean.empty() && clean.back() != ' ') {
            clean += ' ';
            ++characters;
        } else if (size != 0 && !blank && !isHiddenMark(code)) {
            clean += text.substr(0, size);
            ++characters;
        }
        text.remove_prefix(std::max<std::size_t>(1, size));
    }
    return std::string{trimmed(clean)};
}

std::string editJson(const Edit& edit)
{
    std::string json = R"({"planes":[)";
    for (const PlaneId plane : edit.planes)
        json += (json.back() == '[' ? "" : ",") + std::to_string(plane);
    json += ']';
    if (hasText(edit.kind)) {
        json += R"(,"text":)";
        appendJsonText(json, cleanName(edit.text));
    }
    if (canBeTurnedOff(edit.kind))
        json += edit.on ? R"(,"on":true)" : R"(,"on":false)";
    return json + '}';
}

Result<Edit> readEditJson(std::string_view kind, std::string_view payload, const std::string& place)
{
    const auto refuse = [&](const std::string& what) { return fail(ErrorCode::Unreadable, place + ": " + what); };
    const auto known = std::find(kKinds.begin(), kKinds.end(), kind);
    if (known == kKinds.end())
        return refuse("there is no edit " + quotedText(kind));
    if (payload.size() > kMostPayloadBytes)
        return refuse("the payload is larger than " + std::to_string(kMostPayloadBytes) + " bytes");
    std::istringstream in{std::string{payload}};
    const auto object = parseStrictJson(in, place);
    if (!object)
        return tl::unexpected{object.error()};
    Edit edit;
    edit.kind = static_cast<Edit::Kind>(known - kKinds.begin());
    if (!object->is_object() || !object->contains("planes"))
        return refuse("the payload has no list 'planes'");
    for (const auto& [key, value] : object->items()) {
        if (key == "planes") {
            if (const std::string problem = readPlanes(value, edit); !problem.empty())
                return refuse(problem);
        } else if (key == "text" && hasText(edit.kind) && value.is_string())
            edit.text = cleanName(value.get_ref<const std::string&>());
        else if (key == "on" && canBeTurnedOff(edit.kind) && value.is_boolean())
            edit.on = value.get<bool>();
        else
            return refuse(quotedText(key) + " does not belong into the payload of this edit, or is of a wrong type");
    }
    if (hasText(edit.kind) && !object->contains("text"))
        return refuse("the payload has no 'text'");
    return edit;
}

}  // namespace planewright
