// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/formats/message_text.h"

namespace planewright {

namespace {
constexpr std::size_t kLongestQuote = 40;
}

std::string printableText(std::string_view text)
{
    std::string plain{text.substr(0, kLongestQuote)};
    for (char& c : plain) {
        if (c < ' ' || c > '~')
            c = '?';
    }
    return text.size() > kLongestQuote ? plain + "..." : plain;
}

std::string quotedText(std::string_view text)
{
    return "'" + printableText(text) + "'";
}

std::string placeInFile(std::string_view fileName, std::size_t line, std::size_t column, std::string_view name)
{
    std::string place{fileName};
    place += ": ";
    if (line == 0)
        return place;
    place += "line " + std::to_string(line);
    if (column != 0)
        place += ", column " + std::to_string(column);
    if (!name.empty())
        place += " (" + printableText(name) + ")";
    return place + ": ";
}

bool isPlainUtf8(std::string_view text)
{
    for (std::size_t i = 0; i < text.size();) {
        const auto byte = [&](std::size_t at) { return at < text.size() ? static_cast<unsigned char>(text[at]) : 0U; };
        const auto follows = [&](std::size_t at) { return (byte(at) & 0xC0U) == 0x80U; };
        const unsigned lead = byte(i);
        if (lead < 0x80) {
            if ((lead < 0x20 && lead != '\t') || lead == 0x7F)
                return false;
            i += 1;
        } else if (lead >= 0xC2 && lead <= 0xDF && follows(i + 1)) {
            // C1 control characters are as unwelcome as those of ASCII.
            if (lead == 0xC2 && byte(i + 1) < 0xA0)
                return false;
            i += 2;
        } else if (lead >= 0xE0 && lead <= 0xEF && follows(i + 1) && follows(i + 2)) {
            const unsigned code = (lead & 0x0FU) << 12 | (byte(i + 1) & 0x3FU) << 6 | (byte(i + 2) & 0x3FU);
            if (code < 0x800 || (code >= 0xD800 && code <= 0xDFFF))
                return false;
            i += 3;
        } else if (lead >= 0xF0 && lead <= 0xF4 && follows(i + 1) && follows(i + 2) && follows(i + 3)) {
            const unsigned high = (lead & 0x07U) << 6 | (byte(i + 1) & 0x3FU);  // code point / 4096
            if (high < 0x10 || high > 0x10F)
                return false;
            i += 4;
        } else
            return false;
    }
    return true;
}

}  // namespace planewright
