// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/scip/scip_link.h"

#include <algorithm>
#include <array>
#include <span>
#include <utility>
#include <vector>

namespace planewright {

namespace {

constexpr std::chrono::milliseconds kWriteTimeout{500};

}  // namespace

ScipLink::ScipLink(std::unique_ptr<Transport> transport, const Clock& clock)
    : transport_(std::move(transport)), clock_(clock)
{
}

Result<void> ScipLink::send(std::string_view request)
{
    std::vector<std::uint8_t> bytes{request.begin(), request.end()};
    bytes.push_back('\n');
    return transport_->write(bytes, now() + kWriteTimeout);
}

/// False where nothing came before the deadline or a stop.
Result<bool> ScipLink::readMore(Time deadline, const std::stop_token& stop)
{
    std::array<std::uint8_t, 8192> buffer;
    const Result<Transport::Arrival> arrival = transport_->read(buffer, deadline, stop);
    if (!arrival)
        return tl::unexpected{arrival.error()};
    heard_.anything = heard_.anything || arrival->count > 0;
    for (ScipEvent& event : decoder_.push(std::span{buffer}.first(arrival->count))) {
        heard_.scans = heard_.scans || std::holds_alternative<ScipFrame>(event);
        heard_.replies = heard_.replies || std::holds_alternative<ScipReply>(event);
        arrived_.push_back({std::move(event), arrival->at});
    }
    return arrival->count > 0;
}

Result<std::optional<ScipArrival>> ScipLink::next(Time deadline, const std::stop_token& stop)
{
    while (arrived_.empty()) {
        const Result<bool> more = readMore(deadline, stop);
        if (!more)
            return tl::unexpected{more.error()};
        if (!*more)
            return std::nullopt;
    }
    ScipArrival first = std::move(arrived_.front());
    arrived_.pop_front();
    return first;
}

Result<std::optional<ScipAnswer>> ScipLink::ask(std::string_view request, Time patience, const std::stop_token& stop)
{
    arrived_.clear();
    const Time asked = now();
    const Time deadline = asked + patience;
    if (const Result<void> sent = send(request); !sent)
        return tl::unexpected{sent.error()};
    for (;;) {
        Result<std::optional<ScipArrival>> arrival = next(deadline, stop);
        if (!arrival)
            return tl::unexpected{arrival.error()};
        if (!*arrival)
            return std::nullopt;
        if (auto* const reply = std::get_if<ScipReply>(&(*arrival)->event); reply != nullptr && reply->echo == request)
            return ScipAnswer{std::move(*reply), asked, (*arrival)->at};
        if (now() >= deadline)  // a stream that does not end must not be waited for
            return std::nullopt;
    }
}

Result<ScipLink::Heard> ScipLink::discard(Time silence, Time longest, const std::stop_token& stop)
{
    const Heard before = std::exchange(heard_, {});
    const Time end = now() + longest;
    for (bool isSilent = false; !isSilent && now() < end && !stop.stop_requested();) {
        const Result<bool> more = readMore(std::min(end, now() + silence), stop);
        if (!more)
            return tl::unexpected{more.error()};
        isSilent = !*more;
    }
    arrived_.clear();
    // What has not ended by now belongs to what is thrown away.
    decoder_.forget();
    const Heard heard = heard_;
    heard_ = {before.anything || heard.anything, before.scans || heard.scans, before.replies || heard.replies};
    return heard;
}

}  // namespace planewright
