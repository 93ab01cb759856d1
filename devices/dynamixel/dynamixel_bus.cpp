// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/dynamixel/dynamixel_bus.h"

#include <algorithm>
#include <array>

#include "core/types/count_text.h"
#include "devices/dynamixel/echo_filter.h"
#include "devices/dynamixel/packet_parser.h"
#include "devices/dynamixel/status_error.h"

namespace planewright {

namespace {

using namespace std::chrono_literals;

constexpr std::chrono::nanoseconds kLongestReturnDelay = 508us;
constexpr std::chrono::nanoseconds kReserve = 10ms;
constexpr int kBitsOfByte = 10;  // with start and stop bit

/// Bytes of an answer with so much data.
std::size_t answerBytes(DynamixelProtocol protocol, std::size_t data)
{
    return data + (protocol == DynamixelProtocol::One ? 6 : 11);
}

}  // namespace

DynamixelBus::DynamixelBus(Transport& transport, const Clock& clock, const Settings& settings)
    : transport_(transport), clock_(clock), settings_(settings), returnDelay_(kLongestReturnDelay)
{
}

Result<ServoReply> DynamixelBus::ask(const ServoQuestion& question)
{
    const std::vector<std::uint8_t> bytes = encodePacket(protocol_, question.request);
    if (const auto purged = purge(); !purged)
        return tl::unexpected(purged.error());
    ServoReply reply;
    reply.asked = clock_.now();
    if (const auto written = transport_.write(bytes, reply.asked + transferTime(bytes.size()) + 1s); !written)
        return tl::unexpected(written.error());
    if (!question.isAnswered) {
        // The next question must not begin before this one has left.
        if (const auto paused = pause(transferTime(bytes.size()) + returnDelay_, {}); !paused)
            return tl::unexpected(paused.error());
        reply.kind = ServoReply::Kind::Answered;
        return reply;
    }
    if (const auto heard = listen(question, bytes, reply); !heard)
        return tl::unexpected(heard.error());
    finish(bytes.size(), reply);
    count(reply);
    logFault(reply, bytes);
    return reply;
}

Result<void> DynamixelBus::listen(const ServoQuestion& question, std::span<const std::uint8_t> sent, ServoReply& reply)
{
    EchoFilter echo{{sent.begin(), sent.end()}};
    PacketParser parser{protocol_};
    const Time deadline = reply.asked + transferTime(sent.size() + answerBytes(protocol_, question.data.value_or(3))) +
                          returnDelay_ + 2 * settings_.latency + kReserve;
    const Time latest = deadline + question.patience;
    std::array<std::uint8_t, 256> buffer;
    std::size_t heard = 0;
    Time heardAt = reply.asked;
    while (reply.answers == 0 || question.waitsToTheEnd) {
        const Time until = reply.answers == 0 ? latest : deadline;
        const Result<Transport::Arrival> arrival = transport_.read(buffer, until, {});
        if (!arrival)
            return tl::unexpected(arrival.error());
        if (arrival->count == 0)
            break;
        heardAt = arrival->at;
        const std::vector<std::uint8_t> rest = echo.push(std::span{buffer}.first(arrival->count));
        heard += rest.size();
        const std::size_t room = FaultLog::kMostBytes - reply.heard.size();
        reply.heard.insert(reply.heard.end(), rest.begin(),
                           rest.begin() + static_cast<std::ptrdiff_t>(std::min(room, rest.size())));
        for (const DynamixelPacket& packet : parser.push(rest))
            take(question, packet, arrival->at, reply);
        if (clock_.now() > until)
            break;  // whoever talks without end is not waited for
    }
    reply.heardEcho = echo.heardEcho();
    // A ping of 1.0 comes back byte by byte the same from a servo whose supply is out of range. Read on its own, it is
    // an answer; with a second one behind it, it was an echo.
    if (reply.heardEcho && reply.answers == 0 && heard == 0) {
        for (const DynamixelPacket& packet : PacketParser{protocol_}.push(sent))
            take(question, packet, heardAt, reply);
    }
    reply.isTooLate = reply.answers > 0 && reply.arrived > deadline;
    if (reply.answers == 0 && reply.otherNumber < 0 && heard > 0)
        reply.kind = ServoReply::Kind::Damaged;
    return {};
}

void DynamixelBus::take(const ServoQuestion& question, const DynamixelPacket& packet, Time arrived,
                        ServoReply& reply) const
{
    const std::optional<DynamixelStatus> status = statusOf(protocol_, packet);
    if (!status)
        return;
    if (status->id != question.request.id) {
        reply.otherNumber = status->id;
        return;
    }
    // A request that was refused is answered without data.
    const bool isRefusal =
        status->data.empty() && decodeStatusError(protocol_, status->error).request != RequestFault::None;
    if (question.data && status->data.size() != *question.data && !isRefusal)
        return;
    if (++reply.answers == 1) {
        reply.status = *status;
        reply.arrived = arrived;
    }
}

void DynamixelBus::finish(std::size_t sentBytes, ServoReply& reply) const
{
    if (reply.answers > 0) {
        reply.kind = ServoReply::Kind::Answered;
        const Time came = reply.asked + transferTime(sentBytes);
        const Time left = reply.arrived - transferTime(answerBytes(protocol_, reply.status.data.size()));
        reply.measured = came + (left - came) / 2;
        reply.uncertainty = std::max(Time{0}, (left - came) / 2);
    } else if (reply.otherNumber >= 0) {
        reply.kind = ServoReply::Kind::OtherNumber;
    }
}

Result<void> DynamixelBus::pause(Time time, const std::stop_token& stop)
{
    std::array<std::uint8_t, 256> buffer;
    const Time until = clock_.now() + time;
    while (clock_.now() < until && !stop.stop_requested()) {
        if (const auto arrival = transport_.read(buffer, until, stop); !arrival)
            return tl::unexpected(arrival.error());
    }
    return {};
}

Result<void> DynamixelBus::purge()
{
    // Bounded: whoever talks without end is not waited for.
    std::array<std::uint8_t, 256> buffer;
    for (int i = 0; i < 64; ++i) {
        const Result<Transport::Arrival> arrival = transport_.read(buffer, Time{0}, {});
        if (!arrival)
            return tl::unexpected(arrival.error());
        if (arrival->count == 0)
            break;
        if (i == 0)
            countLate();
    }
    return {};
}

DynamixelBus::Time DynamixelBus::transferTime(std::size_t bytes) const
{
    return Time{static_cast<std::int64_t>(bytes) * kBitsOfByte * 1'000'000'000 / settings_.baud};
}

void DynamixelBus::restartCounts()
{
    const std::scoped_lock lock(mutex_);
    health_ = {};
    answered_.clear();
    log_.restartCounts();
    (void)log_.take();
}

/// Of silence the question is logged, of everything else what came.
void DynamixelBus::logFault(const ServoReply& reply, std::span<const std::uint8_t> sent)
{
    if (const std::uint64_t overruns = transport_.health().overruns; overruns != overruns_) {
        log_.add(
            clock_.now(), "adapter-overrun",
            "the adapter lost bytes " + countText(overruns - overruns_, "time") + ": they were not fetched in time",
            reply.heard);
        overruns_ = overruns;
    }
    switch (reply.kind) {
        case ServoReply::Kind::Answered:
        case ServoReply::Kind::Echo:
            return;
        case ServoReply::Kind::Silent:
            return log_.add(clock_.now(), "servo-silent", "a question was not answered", sent);
        case ServoReply::Kind::Damaged:
            return log_.add(clock_.now(), "servo-damaged", "an answer came damaged", reply.heard);
        case ServoReply::Kind::OtherNumber:
            return log_.add(clock_.now(), "servo-other-number",
                            "servo " + std::to_string(reply.otherNumber) + " answered in its place", reply.heard);
    }
}

void DynamixelBus::countLate()
{
    const std::scoped_lock lock(mutex_);
    ++health_.late;
}

void DynamixelBus::count(const ServoReply& reply)
{
    const std::scoped_lock lock(mutex_);
    switch (reply.kind) {
        case ServoReply::Kind::Answered:
        case ServoReply::Kind::Echo:
            ++health_.good;
            answered_.push_back(reply.arrived);
            break;
        case ServoReply::Kind::Silent:
            ++health_.lost;
            break;
        case ServoReply::Kind::Damaged:
        case ServoReply::Kind::OtherNumber:
            ++health_.corrupt;
            break;
    }
    while (!answered_.empty() && answered_.front() <= reply.asked - 1s)
        answered_.pop_front();
}

LinkHealth DynamixelBus::health() const
{
    const std::scoped_lock lock(mutex_);
    LinkHealth health = health_;
    health.faults = log_.counts();
    const TransportHealth transport = transport_.health();
    health.overruns = transport.overruns;
    health.trouble = transport.trouble;
    const Time now = clock_.now();
    health.rate = 0.0;
    for (const Time at : answered_)
        health.rate += at > now - 1s ? 1.0 : 0.0;
    return health;
}

}  // namespace planewright
