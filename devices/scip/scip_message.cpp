// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/scip/scip_message.h"

#include <algorithm>

#include "devices/scip/scip_encoding.h"
#include "devices/scip/scip_frame.h"

namespace planewright {

namespace {

using Lines = std::span<const std::string_view>;
using Read = tl::expected<ScipEvent, ScipDamageKind>;

bool isStatusCharacter(char c)
{
    return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z');
}

/// The status of a line: two characters and their sum, or one of SCIP 1.1 without; empty for what is none.
std::string_view statusOf(std::string_view line)
{
    if (line.size() == 3 && isStatusCharacter(line[0]) && isStatusCharacter(line[1]) && endsWithScipSum(line))
        return line.substr(0, 2);
    if (line.size() == 1 && isStatusCharacter(line[0]))
        return line;
    return {};
}

bool hasFields(std::string_view command)
{
    return command == kScipIdentity || command == kScipLimits || command == kScipState;
}

bool isField(std::string_view line)
{
    return line.size() >= 3 && line[line.size() - 2] == ';' && line.find(':') < line.size() - 2;
}

ScipLine readField(std::string_view line, std::string_view command)
{
    const std::string_view text = line.substr(0, line.size() - 2);
    bool isIntact = line.back() == scipSum(text);
    if (const std::size_t arrow = text.find("<-"); command == kScipState && arrow != std::string_view::npos)
        isIntact = isIntact || line.back() == scipSum(text.substr(0, arrow));
    return {std::string{text}, isIntact};
}

/// Lines of the replies that have some.
tl::expected<std::vector<ScipLine>, ScipDamageKind> readBody(const ScipEcho& echo, Lines body)
{
    std::vector<ScipLine> lines;
    const bool fields = hasFields(echo.command);
    const bool hasTime = echo.command == "TM" && echo.parameters == "1";
    if (!body.empty() && !fields && !hasTime && echo.command.front() != '%')
        return tl::unexpected{ScipDamageKind::Count};
    if (hasTime && body.size() > 1)
        return tl::unexpected{ScipDamageKind::Count};
    for (std::size_t i = 0; i < body.size(); ++i) {
        const std::string_view line = body[i];
        if (line.empty())
            return tl::unexpected{ScipDamageKind::LineTooLong};
        if (!hasTime && beginsScipMessage(body.subspan(i)))
            return tl::unexpected{ScipDamageKind::Interrupted};
        if (fields && isField(line)) {
            lines.push_back(readField(line, echo.command));
            continue;
        }
        if (hasTime && !endsWithScipSum(line))
            return tl::unexpected{ScipDamageKind::Sum};
        lines.push_back({std::string{line.substr(0, line.size() - 1)}, !fields && endsWithScipSum(line)});
    }
    return lines;
}

Read readReply(const ScipEcho& echo, std::string_view status, Lines lines)
{
    const Lines body = lines.subspan(2);
    if (status.size() == 1 && !body.empty())
        return tl::unexpected{ScipDamageKind::Status};
    auto read = readBody(echo, body);
    if (!read)
        return tl::unexpected{read.error()};
    return ScipReply{std::string{lines[0]}, std::string{status}, std::move(*read)};
}

}  // namespace

tl::expected<ScipEvent, ScipDamageKind> readScipMessage(Lines lines)
{
    if (lines[0].empty())
        return tl::unexpected{ScipDamageKind::LineTooLong};
    const std::optional<ScipEcho> echo = readScipEcho(lines[0]);
    if (!echo)
        return tl::unexpected{ScipDamageKind::UnknownEcho};
    const std::string_view status = lines.size() > 1 ? statusOf(lines[1]) : std::string_view{};
    if (status.empty())
        return tl::unexpected{ScipDamageKind::Status};

    const std::optional<ScipMeasurement> measurement = readScipMeasurement(*echo);
    const bool isScan = measurement && (measurement->isStream() ? status == "99" : status == "00");
    if (!isScan)
        return readReply(*echo, status, lines);
    auto frame = readScipFrame(*measurement, lines.subspan(2));
    if (!frame)
        return tl::unexpected{frame.error()};
    frame->echo = lines[0];
    return std::move(*frame);
}

bool beginsScipMessage(Lines lines)
{
    return lines.size() >= 2 && !statusOf(lines[1]).empty() && readScipEcho(lines[0]).has_value();
}

}  // namespace planewright
