// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/emulated/emulated_board.h"

#include <algorithm>

namespace planewright {

using namespace board;

namespace {

using namespace std::chrono_literals;
using Time = EmulatedBoard::Time;

/// What a frame takes one way through USB, and what the board takes to answer.
constexpr Time kUsb = 200us;
constexpr Time kThinking = 60us;
constexpr std::size_t kRepliesKept = 2;
constexpr int kReadingError = 40;

/// Requests that may be done again, whose replies are not kept.
bool isDoneEveryTime(std::uint8_t type)
{
    return type == Hello::kType || type == Heartbeat::kType || type == GetStatus::kType || type == GetConfig::kType;
}

}  // namespace

EmulatedBoardFirmware::NextEdge edgesEvery(Time period, Time phase)
{
    return [period, phase](Time after) {
        const Time since = after - phase;
        const auto edges = since / period - (since % period < 0ns ? 1 : 0);
        return phase + (edges + 1) * period;
    };
}

Result<std::shared_ptr<EmulatedBoard>> EmulatedBoard::make(const EmulatedBoardSetup& setup)
{
    std::vector<std::pair<BoardFault, int>> faults;
    for (const FaultAt& fault : setup.faults) {
        const Result<BoardFault> known = boardFaultOf(fault);
        if (!known)
            return tl::unexpected(known.error());
        faults.emplace_back(*known, fault.step);
    }
    return std::shared_ptr<EmulatedBoard>(new EmulatedBoard(setup, std::move(faults)));
}

EmulatedBoard::EmulatedBoard(const EmulatedBoardSetup& setup, std::vector<std::pair<BoardFault, int>> faults)
    : firmware_({setup.mounting, setup.startPitch, setup.dynamics, setup.serial, setup.clockDrift, setup.nextEdge,
                 setup.bootAt}),
      line_(setup.seed),
      turns_(setup.turns),
      pending_(std::move(faults))
{
    beginFaults(setup.bootAt);
}

void EmulatedBoard::receive(std::span<const std::uint8_t> bytes, Time now)
{
    advance(now);
    heard_.push_back({now + kUsb, {bytes.begin(), bytes.end()}});
}

std::vector<EmulatedOutput> EmulatedBoard::takeOutput(Time now)
{
    advance(now);
    return line_.take(now);
}

std::optional<Time> EmulatedBoard::nextOutput() const
{
    std::optional<Time> first = firmware_.next();
    if (!heard_.empty())
        first = std::min(first.value_or(heard_.front().at), heard_.front().at);
    if (const auto sent = line_.next())
        first = std::min(first.value_or(*sent), *sent);
    return first;
}

bool EmulatedBoard::isConnected(Time now)
{
    advance(now);
    return isConnected_;
}

double EmulatedBoard::pitchAt(Time at)
{
    advance(at);
    return firmware_.servo().pitch(at);
}

void EmulatedBoard::advance(Time to)
{
    for (;;) {
        const std::optional<Time> own = firmware_.next();
        const bool hearsFirst = !heard_.empty() && heard_.front().at <= own.value_or(heard_.front().at);
        const std::optional<Time> moment = hearsFirst ? heard_.front().at : own;
        if (!moment || *moment > to)
            break;
        beginFaults(*moment);
        firmware_.advance(*moment);
        sendEvents();
        if (hearsFirst) {
            const EmulatedOutput bytes = std::move(heard_.front());
            heard_.pop_front();
            hear(bytes);
        }
    }
    beginFaults(to);
    firmware_.advance(to);
    sendEvents();
}

void EmulatedBoard::hear(const EmulatedOutput& bytes)
{
    for (const Frame& frame : parser_.push(bytes.bytes)) {
        if (frame.seq == 0 || frame.isEvent())
            continue;
        firmware_.hear(bytes.at);
        sendEvents();
        answer(frame, bytes.at);
    }
    firmware_.setLosses(parser_.counters().lostBytes, parser_.counters().crc);
}

void EmulatedBoard::answer(const Frame& request, Time now)
{
    const auto kept =
        std::find_if(answered_.begin(), answered_.end(), [&](const Answered& a) { return a.request == request; });
    if (kept != answered_.end()) {
        line_.send(encodeFrame(kept->reply), false, now + kThinking + kUsb);
        return;
    }
    const Frame reply = toFrame(request.seq, firmware_.answer(request, now, now + kThinking));
    if (request.type == Hello::kType) {
        nextEvent_ = kFirstEvent;
        answered_.clear();
    }
    if (!isDoneEveryTime(request.type))
        answered_.push_back({request, reply});
    if (answered_.size() > kRepliesKept)
        answered_.pop_front();
    line_.send(encodeFrame(reply), false, now + kThinking + kUsb);
    sendEvents();
}

void EmulatedBoard::sendEvents()
{
    for (const EmulatedBoardFirmware::Event& event : firmware_.takeEvents()) {
        line_.send(encodeFrame(toFrame(nextEvent_, event.message)), true, event.at + kUsb);
        nextEvent_ = static_cast<std::uint16_t>((nextEvent_ + 1U) | kFirstEvent);
    }
}

void EmulatedBoard::beginFaults(Time now)
{
    for (std::size_t i = 0; i < pending_.size();) {
        const auto [fault, step] = pending_[i];
        if (step > 0 && (!turns_ || turns_(now) < step)) {
            ++i;
            continue;
        }
        pending_.erase(pending_.begin() + static_cast<std::ptrdiff_t>(i));
        begin(fault, now);
    }
}

void EmulatedBoard::begin(BoardFault fault, Time now)
{
    line_.begin(fault);
    switch (fault) {
        case BoardFault::Reset:
            firmware_.advance(now);
            firmware_.reset(now);
            answered_.clear();
            break;
        case BoardFault::Watchdog:
            firmware_.missHeartbeats();
            break;
        case BoardFault::Stall:
            firmware_.servo().stall(now);
            break;
        case BoardFault::Overload:
            firmware_.raise(Fault::Overload, now);
            break;
        case BoardFault::Overheat:
            firmware_.raise(Fault::Overheat, now);
            break;
        case BoardFault::Voltage:
            firmware_.raise(Fault::Voltage, now);
            break;
        case BoardFault::Button:
            firmware_.pressButton(now);
            break;
        case BoardFault::NoSync:
            firmware_.loseSync();
            break;
        case BoardFault::WrongAngle:
            firmware_.setReadingError(kReadingError);
            break;
        case BoardFault::Unplug:
            isConnected_ = false;
            break;
        default:  // what goes wrong on the line
            break;
    }
}

}  // namespace planewright
