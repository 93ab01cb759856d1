// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/scip/scip_decoder.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include "devices/scip/scip_message.h"

namespace planewright {

std::vector<ScipEvent> ScipDecoder::push(std::span<const std::uint8_t> bytes)
{
    std::vector<ScipEvent> events;
    while (!bytes.empty()) {
        const auto feed = std::find(bytes.begin(), bytes.end(), std::uint8_t{'\n'});
        const auto length = static_cast<std::size_t>(feed - bytes.begin());
        const std::size_t room = kLongestLine - (message_.size() - lineBegin_);
        message_.append(reinterpret_cast<const char*>(bytes.data()), std::min(room, length));
        lineIsTooLong_ = lineIsTooLong_ || length > room;
        if (feed == bytes.end())
            break;
        endLine(events);
        bytes = bytes.subspan(length + 1);
    }
    return events;
}

void ScipDecoder::forget()
{
    message_.clear();
    lines_.clear();
    lineBegin_ = 0;
    lineIsTooLong_ = false;
}

void ScipDecoder::endLine(std::vector<ScipEvent>& events)
{
    const std::size_t length = message_.size() - lineBegin_;
    if (length == 0) {
        if (!lines_.empty())
            endMessage(events);
        forget();
        return;
    }
    lines_.push_back({lineBegin_, length, std::exchange(lineIsTooLong_, false)});
    message_ += '\n';
    lineBegin_ = message_.size();
    if (message_.size() + kLongestLine + 1 > kLongestFrame) {
        reject(ScipDamageKind::FrameTooLong, message_, events);
        forget();
    }
}

/// Reads the message; where that fails, what stands before the next beginning in it, and then the rest likewise.
void ScipDecoder::endMessage(std::vector<ScipEvent>& events)
{
    const std::string_view message = message_;
    std::vector<std::string_view> texts;
    texts.reserve(lines_.size());
    for (const Line& line : lines_)
        texts.push_back(line.isTooLong ? std::string_view{} : message.substr(line.begin, line.size));

    for (std::size_t from = 0; from < texts.size();) {
        const std::span rest = std::span{texts}.subspan(from);
        std::size_t count = rest.size();
        auto read = readScipMessage(rest);
        if (!read) {
            count = 1;
            while (count < rest.size() && !beginsScipMessage(rest.subspan(count)))
                ++count;
            if (count < rest.size() && beginsScipMessage(rest))
                read = readScipMessage(rest.first(count)).map_error([](auto) { return ScipDamageKind::Interrupted; });
        }
        const std::size_t begin = lines_[from].begin;
        from += count;
        if (read)
            events.push_back(std::move(*read));
        else
            reject(read.error(),
                   message.substr(begin, (from < texts.size() ? lines_[from].begin : message.size()) - begin), events);
    }
}

void ScipDecoder::reject(ScipDamageKind kind, std::string_view bytes, std::vector<ScipEvent>& events)
{
    ++damage_.counts[static_cast<std::size_t>(kind)];
    events.emplace_back(ScipDamage{kind, std::string{bytes}});
}

}  // namespace planewright
