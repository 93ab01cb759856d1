// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/formats/strict_json.h"

#include <algorithm>
#include <string_view>
#include <utility>
#include <vector>

#include "core/formats/message_text.h"
#include "core/formats/number_cells.h"

namespace planewright {

namespace {

using nlohmann::json;

/// Builds the value of a text event by event, so that what breaks a limit stops at once.
class StrictBuilder : public nlohmann::json_sax<json> {
public:
    bool null() override { return put(nullptr); }
    bool boolean(bool value) override { return put(value); }
    bool number_integer(number_integer_t value) override { return put(value); }
    bool number_unsigned(number_unsigned_t value) override { return put(value); }
    bool number_float(number_float_t value, const string_t&) override { return put(value); }
    bool string(string_t& value) override { return put(std::move(value)); }
    bool binary(binary_t&) override { return false; }
    bool start_object(std::size_t) override { return open(json::object()); }
    bool end_object() override { return close(); }
    bool start_array(std::size_t) override { return open(json::array()); }
    bool end_array() override { return close(); }

    bool key(string_t& key) override
    {
        json& object = *open_.back();
        if (object.contains(key)) {
            problem = "the key " + quotedText(key) + " is there twice; remove one of the two";
            return false;
        }
        slot_ = &object[key];
        return true;
    }

    bool parse_error(std::size_t position, const std::string& token, const json::exception&) override
    {
        errorPosition = position;
        problem = "this is not JSON at " + quotedText(token) + "; correct it there";
        return false;
    }

    json root = json::value_t::null;  // nlohmann's constructor without it promises more than it can hold
    std::string problem;
    std::size_t errorPosition = 0;  ///< bytes up to a fault of syntax; 0 where there is none

private:
    json* place(json value)
    {
        if (++values_ > kMaxJsonValues) {
            problem = "the file holds more than " + std::to_string(kMaxJsonValues) + " values; give a smaller one";
            return nullptr;
        }
        if (open_.empty())
            return &(root = std::move(value));
        if (open_.back()->is_array()) {
            open_.back()->push_back(std::move(value));
            return &open_.back()->back();
        }
        return &(*slot_ = std::move(value));
    }

    bool put(json value) { return place(std::move(value)) != nullptr; }

    bool open(json value)
    {
        if (open_.size() == kMaxJsonDepth) {
            problem = "the file nests deeper than " + std::to_string(kMaxJsonDepth) + " levels; give a flatter one";
            return false;
        }
        json* const placed = place(std::move(value));
        if (placed != nullptr)
            open_.push_back(placed);
        return placed != nullptr;
    }

    bool close()
    {
        open_.pop_back();
        return true;
    }

    // A container does not move while one inside it is open: nothing is added to it then.
    std::vector<json*> open_;
    json* slot_ = nullptr;
    std::size_t values_ = 0;
};

}  // namespace

Result<json> parseStrictJson(std::istream& in, const std::string& fileName)
{
    std::string text;
    std::vector<char> piece(std::size_t{64} * 1024);
    while (in.read(piece.data(), static_cast<std::streamsize>(piece.size())), in.gcount() > 0) {
        text.append(piece.data(), static_cast<std::size_t>(in.gcount()));
        if (text.size() > kMaxJsonBytes)
            return fail(ErrorCode::Unreadable, placeInFile(fileName, 0) + "the file is larger than " +
                                                   std::to_string(kMaxJsonBytes >> 20) +
                                                   " MiB; give one that this program wrote");
    }
    if (in.bad() || !in.eof())
        return fail(ErrorCode::Unreadable, placeInFile(fileName, 0) +
                                               "the file cannot be read; check that it is a file and that its disk is "
                                               "sound");
    StrictBuilder builder;
    if (json::sax_parse(text, &builder))
        return std::move(builder.root);
    std::size_t line = 0;
    std::size_t column = 0;
    if (builder.errorPosition != 0) {
        const std::string_view before{text.data(), std::min(builder.errorPosition - 1, text.size())};
        line = 1 + static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n'));
        column = before.size() - (before.rfind('\n') + 1) + 1;  // npos + 1 is 0: the first line
    }
    return fail(ErrorCode::Unreadable, placeInFile(fileName, line, column) + builder.problem);
}

Result<void> checkJsonFormat(const json& object, std::string_view name, int version, const std::string& fileName)
{
    const std::string wanted = std::string{name} + " " + std::to_string(version);
    const auto refuse = [&](const std::string& what) {
        return fail(ErrorCode::Unreadable, placeInFile(fileName, 0) + what);
    };
    if (!object.is_object() || !object.contains("format") || !object["format"].is_string())
        return refuse(R"(there is no "format":")" + wanted + R"("; give a file of this format)");
    const auto& format = object["format"].get_ref<const std::string&>();
    if (format == wanted)
        return {};
    if (format.starts_with(std::string{name} + " ")) {
        const auto number = readNumber<int>(std::string_view{format}.substr(name.size() + 1));
        if (number && *number > version)
            return refuse("the file is of the newer format " + quotedText(format) + " and this program reads '" +
                          wanted + "'; use a newer version of the program");
    }
    return refuse("the format is " + quotedText(format) + "; give a file of the format '" + wanted + "'");
}

}  // namespace planewright
