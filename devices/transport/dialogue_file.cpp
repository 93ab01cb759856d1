// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/transport/dialogue_file.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <filesystem>
#include <string_view>
#include <system_error>
#include <utility>

namespace planewright {

namespace {

constexpr std::string_view kMagic = "planewright-dialogue ";
constexpr std::string_view kDigits = "0123456789ABCDEF";
/// Longer than any dialogue, and far from where nanoseconds end.
constexpr std::chrono::nanoseconds kLongest = std::chrono::hours{24 * 365};

char markOf(DialogueEvent::Kind kind)
{
    switch (kind) {
        case DialogueEvent::Kind::ToDevice:
            return '>';
        case DialogueEvent::Kind::FromDevice:
            return '<';
        case DialogueEvent::Kind::Lost:
            break;
    }
    return '!';
}

std::optional<DialogueEvent::Kind> kindOf(std::string_view mark)
{
    for (const auto kind :
         {DialogueEvent::Kind::ToDevice, DialogueEvent::Kind::FromDevice, DialogueEvent::Kind::Lost}) {
        if (mark.size() == 1 && mark[0] == markOf(kind))
            return kind;
    }
    return std::nullopt;
}

/// Takes what stands before the next space off a text, and the space.
std::string_view takeWord(std::string_view& text)
{
    const std::size_t end = std::min(text.find(' '), text.size());
    const std::string_view word = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    return word;
}

/// Takes one escape, which begins behind its backslash, off a text; nothing where it is none.
std::optional<std::uint8_t> takeEscape(std::string_view& text)
{
    if (text.empty())
        return std::nullopt;
    const char kind = text.front();
    text.remove_prefix(1);
    if (kind == '\\')
        return '\\';
    if (kind == 'n')
        return '\n';
    if (kind == 'r')
        return '\r';
    if (kind != 'x' || text.size() < 2)
        return std::nullopt;
    std::uint8_t byte = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + 2, byte, 16);
    if (error != std::errc{} || end != text.data() + 2)
        return std::nullopt;
    text.remove_prefix(2);
    return byte;
}

/// What a text says; nothing where it has an escape that is none, or a byte that must be one.
std::optional<std::vector<std::uint8_t>> bytesOfText(std::string_view text)
{
    std::vector<std::uint8_t> bytes;
    while (!text.empty()) {
        const auto byte = static_cast<std::uint8_t>(text.front());
        text.remove_prefix(1);
        if (byte != '\\') {
            if (byte < ' ' || byte > '~')
                return std::nullopt;
            bytes.push_back(byte);
        } else if (const auto escaped = takeEscape(text)) {
            bytes.push_back(*escaped);
        } else {
            return std::nullopt;
        }
    }
    return bytes;
}

/// Bytes from `first` of printable ASCII on stand for themselves.
std::string escaped(std::span<const std::uint8_t> bytes, std::uint8_t first)
{
    std::string text;
    for (const std::uint8_t byte : bytes) {
        if (byte == '\n')
            text += "\\n";
        else if (byte == '\r')
            text += "\\r";
        else if (byte == '\\')
            text += "\\\\";
        else if (byte >= first && byte <= '~')
            text += static_cast<char>(byte);
        else
            text += {'\\', 'x', kDigits[byte >> 4], kDigits[byte & 0xF]};
    }
    return text;
}

constexpr std::size_t kDecimals = 3;

/// Microseconds, with no more decimals than it needs.
std::string timeText(std::chrono::nanoseconds at)
{
    std::string text = std::to_string(at.count() / 1000);
    if (at.count() % 1000 == 0)
        return text;
    const std::string decimals = std::to_string(at.count() % 1000);
    text += '.' + std::string(kDecimals - decimals.size(), '0') + decimals;
    return text.substr(0, text.find_last_not_of('0') + 1);
}

std::optional<std::chrono::nanoseconds> timeOf(std::string_view text)
{
    const std::size_t point = std::min(text.find('.'), text.size());
    std::string decimals{text.substr(std::min(point + 1, text.size()))};
    const bool hasDecimals = point < text.size();
    if (hasDecimals && (decimals.empty() || decimals.size() > kDecimals))
        return std::nullopt;
    decimals.resize(kDecimals, '0');
    std::string digits{text.substr(0, point)};
    digits += decimals;
    std::int64_t at = -1;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), at);
    if (point == 0 || error != std::errc{} || end != digits.data() + digits.size() || at < 0 || at > kLongest.count())
        return std::nullopt;
    return std::chrono::nanoseconds{at};
}

}  // namespace

std::string dialogueText(std::span<const std::uint8_t> bytes)
{
    return escaped(bytes, ' ' + 1);
}

std::string quotedDialogue(std::span<const std::uint8_t> bytes)
{
    constexpr std::size_t kMost = 24;
    return "'" + dialogueText(bytes.first(std::min(bytes.size(), kMost))) + (bytes.size() > kMost ? "…'" : "'");
}

std::string dialogueLines(const DialogueEvent& event)
{
    const std::string beginning = timeText(event.at) + " " + markOf(event.kind) + " ";
    std::span<const std::uint8_t> rest = event.bytes;
    if (event.kind == DialogueEvent::Kind::Lost)
        return beginning + escaped(rest.first(std::min(rest.size(), kMostDialogueBytes)), ' ') + "\n";
    std::string lines;
    while (!rest.empty()) {
        const auto piece = rest.first(std::min(rest.size(), kMostDialogueBytes));
        lines += beginning + dialogueText(piece) + "\n";
        rest = rest.subspan(piece.size());
    }
    return lines;
}

Result<DialogueReader> DialogueReader::open(const std::string& path)
{
    DialogueReader reader{path};
    const auto refuse = [&](const std::string& why) { return fail(ErrorCode::Unreadable, path + ": " + why); };
    std::error_code error;
    // What is no plain file may have no end, or wait for somebody to write.
    if (!std::filesystem::is_regular_file(path, error))
        return refuse(std::filesystem::exists(path, error) ? "is no plain file" : "there is no such file");
    reader.file_.open(path, std::ios::binary);
    if (!reader.file_)
        return refuse("cannot be opened; check its permissions");
    const Result<bool> first = reader.readLine();
    if (!first)
        return tl::unexpected<Error>(first.error());
    if (*first && reader.text_ == kDialogueFirstLine)
        return reader;
    if (*first && reader.text_.starts_with(kMagic))
        return refuse("is a dialogue of version '" + reader.text_.substr(kMagic.size()) +
                      "', and this program reads version 1");
    return refuse("is no recorded dialogue; its first line must be '" + std::string{kDialogueFirstLine} + "'");
}

Result<std::optional<DialogueEvent>> DialogueReader::next()
{
    do {
        const Result<bool> isThere = readLine();
        if (!isThere)
            return tl::unexpected<Error>(isThere.error());
        if (!*isThere)
            return std::nullopt;
    } while (text_.empty() || text_.front() == '#');
    if (isLost_)
        return refuse("nothing may come after the link was lost");
    std::string_view rest = text_;
    const std::string_view time = takeWord(rest);
    const auto kind = kindOf(takeWord(rest));
    auto bytes = bytesOfText(rest);
    const auto at = timeOf(time);
    if (!at)
        return refuse("begins with no time in microseconds, with three decimals at most");
    if (!kind)
        return refuse("behind the time there must be '>', '<' or '!' between spaces");
    if (!bytes)
        return refuse(R"(bytes are printable ASCII, \\, \n, \r or \x with two digits)");
    if (*kind != DialogueEvent::Kind::Lost && bytes->empty())
        return refuse("no bytes");
    if (*at < last_)
        return refuse("time runs backwards");
    last_ = *at;
    isLost_ = *kind == DialogueEvent::Kind::Lost;
    return DialogueEvent{*kind, last_, std::move(*bytes)};
}

Result<bool> DialogueReader::readLine()
{
    std::array<char, kLongestDialogueLine + 2> buffer{};
    file_.getline(buffer.data(), buffer.size());
    const auto count = static_cast<std::size_t>(file_.gcount());
    if (file_.bad())
        return refuse("cannot be read further");
    if (file_.eof())
        return false;
    ++line_;
    if (file_.fail())
        return refuse("is longer than any line of a dialogue");
    text_.assign(buffer.data(), count - 1);  // the line feed is counted
    return true;
}

tl::unexpected<Error> DialogueReader::refuse(const std::string& why) const
{
    return fail(ErrorCode::Unreadable, place() + ": " + why);
}

}  // namespace planewright
