// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/board/board_link.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "core/types/count_text.h"

namespace planewright {

using namespace board;

namespace {

using namespace std::chrono_literals;
using Time = BoardLink::Time;

constexpr Time kWritePatience = 100ms;
/// More is not remembered: what is asked for at the same time is few, and a board may say anything.
constexpr std::size_t kMostWaiting = 32;
constexpr std::size_t kMostUnfetched = 2048;
/// A device that talks without end is no board; the first reply will tell.
constexpr std::size_t kMostStale = 1U << 20;
constexpr std::uint16_t kLastSeq = 0x7FFF;

/// The board's clock in an event.
std::optional<std::uint64_t> stampOf(const Message& message)
{
    return std::visit(
        []<class T>(const T& known) -> std::optional<std::uint64_t> {
            if constexpr (requires { known.atUs; })
                return known.atUs;
            else
                return std::nullopt;
        },
        message);
}

struct Words {
    std::string_view code;
    std::string_view text;
};

Words wordsFor(Damage damage)
{
    switch (damage) {
        case Damage::Cobs:
            return {"board-cobs", "a frame that is not stuffed as it must be"};
        case Damage::Length:
            return {"board-length", "a frame that is too long, or not as long as it says"};
        case Damage::Crc:
            return {"board-crc", "a frame with a wrong checksum"};
        case Damage::Version:
            break;
    }
    return {"board-version", "a frame of another version of the protocol"};
}

template <class T>
void keepLast(std::deque<T>& all, std::size_t most)
{
    while (all.size() > most)
        all.pop_front();
}

}  // namespace

BoardLink::BoardLink(std::unique_ptr<Transport> transport, const Clock& clock, const BoardTiming& timing)
    : transport_(std::move(transport)),
      clock_(clock),
      timing_(timing),
      // Replies to a program before us may still be under way: they shall not have our numbers.
      lastSeq_(static_cast<std::uint16_t>(clock.now() / 1us % kLastSeq))
{
}

BoardLink::Request BoardLink::prepare(const Message& message)
{
    const std::scoped_lock lock(mutex_);
    lastSeq_ = lastSeq_ == kLastSeq ? std::uint16_t{1} : static_cast<std::uint16_t>(lastSeq_ + 1);
    const Frame frame = toFrame(lastSeq_, message);
    Request request{frame.seq, frame.type, encodeFrame(frame)};
    if (frame.type == Hello::kType)
        request.bytes.insert(request.bytes.begin(), 0);  // ends what somebody else has left unfinished
    return request;
}

Result<BoardLink::Received> BoardLink::ask(const Request& request, const Guard& mayGo, Patience patience,
                                           const std::stop_token& stop)
{
    const Result<std::optional<Received>> reply = tryToAsk(request, mayGo, patience, stop);
    if (!reply)
        return tl::unexpected(reply.error());
    if (!*reply)
        return fail(ErrorCode::DeviceLost, transport_->name() + ": the control board did not answer " +
                                               std::to_string(patience.tries) + " times; check its cable and power");
    return **reply;
}

Result<std::optional<BoardLink::Received>> BoardLink::tryToAsk(const Request& request, const Guard& mayGo,
                                                               Patience patience, const std::stop_token& stop)
{
    std::unique_lock lock(mutex_);
    awaited_[request.seq] = {request.type, std::nullopt};
    Result<std::optional<Received>> reply{std::nullopt};
    for (int left = patience.tries; left > 0 && reply && !*reply; --left) {
        reply = askOnce(lock, request, mayGo, patience.reply, stop);
        if (reply && !*reply) {
            ++missing_;
            log_.add(clock_.now(), "board-no-reply", "a request was not answered", request.bytes);
        }
    }
    awaited_.erase(request.seq);
    return reply;
}

Result<std::optional<BoardLink::Received>> BoardLink::askOnce(std::unique_lock<std::mutex>& lock,
                                                              const Request& request, const Guard& mayGo, Time patience,
                                                              const std::stop_token& stop)
{
    lock.unlock();
    const Result<void> written = write(request.bytes, mayGo);
    lock.lock();
    if (!written)
        return tl::unexpected(written.error());
    for (const Time deadline = clock_.now() + patience;;) {
        const Awaited& awaited = awaited_[request.seq];
        if (awaited.reply)
            return awaited.reply;
        if (stop.stop_requested())
            return fail(ErrorCode::Interrupted, transport_->name() + ": stopped while waiting for the board");
        if (clock_.now() >= deadline)
            return std::nullopt;
        lock.unlock();
        const Result<void> beaten = beatWhenDue();
        lock.lock();
        if (!beaten)
            return tl::unexpected(beaten.error());
        const Result<std::size_t> pumped = pump(lock, beats_ ? std::min(deadline, nextBeat_) : deadline, stop);
        if (!pumped && !awaited.reply)
            return tl::unexpected(pumped.error());
    }
}

Result<void> BoardLink::post(const Message& message)
{
    const Request request = prepare(message);
    {
        const std::scoped_lock lock(mutex_);
        posted_.push_back(request.seq);
        keepLast(posted_, kMostWaiting);
    }
    return write(request.bytes, {});
}

Result<std::optional<BoardLink::Received>> BoardLink::next(Time deadline, const std::stop_token& stop)
{
    std::unique_lock lock(mutex_);
    for (bool isFirst = true;; isFirst = false) {
        if (!inbox_.empty()) {
            const Received received = inbox_.front();
            inbox_.pop_front();
            return received;
        }
        if (!isFirst && (clock_.now() >= deadline || stop.stop_requested()))
            return std::nullopt;
        lock.unlock();
        const Result<void> beaten = beatWhenDue();
        lock.lock();
        if (!beaten)
            return tl::unexpected(beaten.error());
        const Result<std::size_t> pumped = pump(lock, beats_ ? std::min(deadline, nextBeat_) : deadline, stop);
        if (!pumped && inbox_.empty())
            return tl::unexpected(pumped.error());
    }
}

Result<void> BoardLink::beginAnew()
{
    std::unique_lock lock(mutex_);
    for (std::size_t thrownAway = 0; thrownAway < kMostStale;) {
        const Result<std::size_t> read = pump(lock, clock_.now(), {});
        if (!read)
            return tl::unexpected(read.error());
        if (*read == 0)
            break;
        thrownAway += *read;
    }
    parser_ = {};
    sync_.restart();
    inbox_.clear();
    sentBeats_.clear();
    posted_.clear();
    missing_ = unreadable_ = lostEvents_ = 0;
    log_.restartCounts();
    return {};
}

void BoardLink::setBeating(bool beats)
{
    const std::scoped_lock lock(mutex_);
    beats_ = beats;
    unanswered_ = 0;
}

Result<void> BoardLink::synchronise(const std::stop_token& stop)
{
    const Result<std::uint16_t> seq = beat();
    if (!seq)
        return tl::unexpected(seq.error());
    std::unique_lock lock(mutex_);
    const auto isUnanswered = [&] {
        return std::any_of(sentBeats_.begin(), sentBeats_.end(), [&](const auto& b) { return b.first == *seq; });
    };
    for (const Time deadline = clock_.now() + timing_.reply; isUnanswered() && clock_.now() < deadline;) {
        if (stop.stop_requested())
            return fail(ErrorCode::Interrupted, transport_->name() + ": stopped while comparing clocks");
        if (const auto pumped = pump(lock, deadline, stop); !pumped)
            return tl::unexpected(pumped.error());
    }
    return {};
}

Result<void> BoardLink::write(const std::vector<std::uint8_t>& bytes, const Guard& mayGo)
{
    const std::scoped_lock lock(writing_);
    if (mayGo) {
        if (Result<void> allowed = mayGo(); !allowed)
            return allowed;
    }
    return transport_->write(bytes, clock_.now() + kWritePatience);
}

Result<void> BoardLink::beatWhenDue()
{
    {
        const std::scoped_lock lock(mutex_);
        if (!beats_ || clock_.now() < nextBeat_)
            return {};
        if (unanswered_ >= timing_.unansweredBeats)
            return fail(ErrorCode::DeviceLost, transport_->name() +
                                                   ": nothing comes from the control board any more; it "
                                                   "stops the motor by itself. Check its cable and "
                                                   "power, and connect it again");
    }
    const Result<std::uint16_t> sent = beat();
    return sent ? Result<void>{} : tl::unexpected(sent.error());
}

Result<std::uint16_t> BoardLink::beat()
{
    const Time now = clock_.now();
    const auto hostUs = std::chrono::duration_cast<std::chrono::microseconds>(now).count();
    const Request request = prepare(Heartbeat{static_cast<std::uint64_t>(hostUs)});
    {
        const std::scoped_lock lock(mutex_);
        nextBeat_ = now + timing_.heartbeat;
        ++unanswered_;
        sentBeats_.emplace_back(request.seq, now);
        keepLast(sentBeats_, kMostWaiting);
    }
    bool isSilenced = false;
    const Result<void> written = write(request.bytes, [&]() -> Result<void> {
        isSilenced = !beats_;
        return isSilenced ? fail(ErrorCode::Interrupted, "no heartbeat while the board is to stop") : Result<void>{};
    });
    if (!written && !isSilenced)
        return tl::unexpected(written.error());
    return request.seq;
}

Result<std::size_t> BoardLink::pump(std::unique_lock<std::mutex>& lock, Time until, const std::stop_token& stop)
{
    if (isRead_) {
        clock_.wait(lock, changed_, stop, until);
        return 0;
    }
    isRead_ = true;
    lock.unlock();
    std::array<std::uint8_t, 512> bytes;
    const Result<Transport::Arrival> arrival = transport_->read(bytes, until, stop);
    lock.lock();
    isRead_ = false;
    changed_.notify_all();
    if (!arrival)
        return tl::unexpected(arrival.error());
    for (const Frame& frame : parser_.push({bytes.data(), arrival->count}))
        deliver(frame, arrival->at);
    logDamage(arrival->at);
    return arrival->count;
}

/// What the parser threw away, and events that are missing.
void BoardLink::logDamage(Time at)
{
    for (const FrameParser::Damaged& damaged : parser_.damaged()) {
        const auto [code, text] = wordsFor(damaged.damage);
        log_.add(at, code, std::string{text}, damaged.bytes);
    }
    const std::uint64_t lost = parser_.counters().lostEvents;
    if (lost == lostEvents_)
        return;
    log_.add(at, "board-lost-events", countText(lost - lostEvents_, "event") + " did not come");
    lostEvents_ = lost;
    lostAt_ = clock_.now();
}

void BoardLink::deliver(const Frame& frame, Time at)
{
    rate_.count(at);
    unanswered_ = 0;
    const tl::expected<Message, NakCode> message = toMessage(frame);
    if (!message) {
        // Events that are not known are those of a newer firmware.
        if (!frame.isEvent() || message.error() != NakCode::UnknownType) {
            ++unreadable_;
            log_.add(at, "board-unreadable", "a message that cannot be read: " + toText(message.error()),
                     encodeFrame(frame));
        }
        return;
    }
    if (std::holds_alternative<HelloReply>(*message)) {
        // It may have been reset: times of before say nothing about those of now.
        sync_.restart();
        lastBeatUs_ = 0;
    }
    Received received{*message, frame.seq, at, std::nullopt, Time{0}, ++order_};
    if (const auto stamp = stampOf(received.message)) {
        received.happened = toHost(*stamp);
        received.uncertainty = received.happened ? sync_.roundTrip() / 2 : Time{0};
    }
    if (frame.isEvent() ? frame.type >= SliceEvent::kType : deliverReply(received, frame.type))
        inbox_.push_back(received);
    while (inbox_.size() > kMostUnfetched) {
        inbox_.pop_front();
        ++missing_;
        log_.add(at, "board-unfetched", "messages came faster than they were fetched");
    }
}

/// True for a reply that next() gives.
bool BoardLink::deliverReply(const Received& received, std::uint8_t type)
{
    if (const auto awaited = awaited_.find(received.seq); awaited != awaited_.end()) {
        Awaited& request = awaited->second;
        if (!request.reply && (type == replyType(request.request) || type == Nak::kType))
            request.reply = received;
        return false;
    }
    const auto beat = std::find_if(sentBeats_.begin(), sentBeats_.end(),
                                   [&](const auto& sent) { return sent.first == received.seq; });
    if (const auto* reply = std::get_if<HeartbeatReply>(&received.message);
        reply != nullptr && beat != sentBeats_.end()) {
        compareClocks(*reply, beat->second, received.at);
        sentBeats_.erase(sentBeats_.begin(), beat + 1);
        return true;
    }
    const auto posted = std::find(posted_.begin(), posted_.end(), received.seq);
    if (posted == posted_.end())
        return false;
    posted_.erase(posted);
    return true;
}

std::optional<Time> BoardLink::toHost(std::uint64_t boardUs) const
{
    return isTooSlow() ? std::nullopt : sync_.toHost(boardUs);
}

void BoardLink::compareClocks(const HeartbeatReply& reply, Time sent, Time received)
{
    const auto us = [](std::uint64_t value) {
        return std::chrono::microseconds{static_cast<std::int64_t>(std::min(value, std::uint64_t{1} << 60))};
    };
    if (reply.receivedUs < lastBeatUs_)
        sync_.restart();
    lastBeatUs_ = reply.receivedUs;
    if (!sync_.add({sent, us(reply.receivedUs), us(reply.sentUs), received})) {
        ++unreadable_;
        log_.add(received, "board-times", "a heartbeat whose times cannot be");
    }
}

}  // namespace planewright
