// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

#include "devices/board/board_message.h"
#include "devices/board/clock_sync.h"
#include "devices/board/frame_parser.h"
#include "devices/board/frame_rate.h"
#include "devices/clock.h"
#include "devices/laser.h"
#include "devices/transport/transport.h"

namespace planewright {

/// How patient a host is with a board.
struct BoardTiming {
    std::chrono::milliseconds heartbeat{50};
    std::chrono::milliseconds reply{50};        ///< for a reply; then the same request goes out again
    int tries = 3;                              ///< how often in all
    std::chrono::milliseconds firstReply{200};  ///< for the reply to the first HELLO
    int firstTries = 10;
    int unansweredBeats = 6;  ///< when nothing at all has come for so many heartbeats, the board is lost
};

/// Requests and their replies, events, heartbeats and the clocks, over a transport. Any thread may call anything.
///
/// There is no thread in it: of the threads that wait for something one reads, and hands out what comes; the others
/// wait until it has. So a request never waits for another one's reply.
class BoardLink {
public:
    using Time = std::chrono::nanoseconds;

    BoardLink(std::unique_ptr<Transport> transport, const Clock& clock, const BoardTiming& timing);

    /// A message that has come.
    struct Received {
        board::Message message;
        std::uint16_t seq = 0;
        Time at{0};                    ///< when, host clock
        std::optional<Time> happened;  ///< an event: when that was, host clock; empty where that is not known to 5 ms
        Time uncertainty{0};           ///< of that: half of what the quickest heartbeat took
        std::uint64_t order = 0;       ///< grows with every message
    };

    /// A request with its number: what goes out again is the same to the byte, and done once.
    struct Request {
        std::uint16_t seq = 0;
        std::uint8_t type = 0;
        std::vector<std::uint8_t> bytes;
    };
    Request prepare(const board::Message& message);

    /// Asked right before a request is written, while nothing else is: an error keeps it back.
    using Guard = std::function<Result<void>()>;

    /// How long, and how often.
    struct Patience {
        std::chrono::milliseconds reply;
        int tries;
    };
    Patience patience() const { return {timing_.reply, timing_.tries}; }

    /// Sends a request and waits for its reply, which may be NAK; empty where none comes. Errors: DeviceLost: the link
    /// is gone; Interrupted: a stop; the guard's.
    Result<std::optional<Received>> tryToAsk(const Request& request, const Guard& mayGo, Patience patience,
                                             const std::stop_token& stop);
    /// The same; that none comes is DeviceLost.
    Result<Received> ask(const Request& request, const Guard& mayGo, Patience patience, const std::stop_token& stop);

    /// Sends a request whose reply comes with next().
    Result<void> post(const board::Message& message);

    /// The next event, reply to post() or to a heartbeat; empty at the deadline or a stop. A deadline in the past gives
    /// what is there. Errors (DeviceLost): the link is gone, or the board has been silent for too long.
    Result<std::optional<Received>> next(Time deadline, const std::stop_token& stop);

    /// Throws away what has come for somebody else, and counts from zero. Errors (DeviceLost): the link is gone.
    Result<void> beginAnew();

    /// Whether whoever waits also sends heartbeats. While it is off none is written, not even one that is due.
    void setBeating(bool beats);
    /// One heartbeat at once, and waits for its reply.
    Result<void> synchronise(const std::stop_token& stop);

    /// Counters, and what was lost of late; the board's own troubles are not in it.
    LinkHealth health() const;
    FaultLog& log() { return log_; }
    /// Empty, or why the moments of events are not known.
    std::string slowness() const;
    std::string name() const { return transport_->name(); }

private:
    struct Awaited {
        std::uint8_t request = 0;
        std::optional<Received> reply;
    };

    Result<std::optional<Received>> askOnce(std::unique_lock<std::mutex>& lock, const Request& request,
                                            const Guard& mayGo, Time patience, const std::stop_token& stop);
    Result<void> write(const std::vector<std::uint8_t>& bytes, const Guard& mayGo);
    Result<void> beatWhenDue();
    /// Gives the number of the heartbeat.
    Result<std::uint16_t> beat();
    /// Waits until something has come or a moment: reads, or waits for whoever reads. Gives how many bytes were read.
    Result<std::size_t> pump(std::unique_lock<std::mutex>& lock, Time until, const std::stop_token& stop);
    void deliver(const board::Frame& frame, Time at);
    void logDamage(Time at);
    bool deliverReply(const Received& received, std::uint8_t type);
    std::optional<Time> toHost(std::uint64_t boardUs) const;
    bool isTooSlow() const;
    std::string slownessText() const;
    void compareClocks(const board::HeartbeatReply& reply, Time sent, Time received);

    const std::unique_ptr<Transport> transport_;
    const Clock& clock_;
    const BoardTiming timing_;
    std::atomic<bool> beats_{false};

    std::mutex writing_;        ///< held while a frame is written; never together with mutex_
    mutable std::mutex mutex_;  ///< everything below
    std::condition_variable_any changed_;
    bool isRead_ = false;  ///< some thread reads
    board::FrameParser parser_;
    board::ClockSync sync_;
    board::FrameRate rate_;
    std::uint16_t lastSeq_;
    std::map<std::uint16_t, Awaited> awaited_;
    std::deque<std::uint16_t> posted_;
    std::deque<std::pair<std::uint16_t, Time>> sentBeats_;  ///< without a reply yet, and when they were sent
    std::deque<Received> inbox_;
    std::uint64_t order_ = 0;
    std::uint64_t lastBeatUs_ = 0;  ///< board clock when the last heartbeat reached it
    Time nextBeat_{0};
    int unanswered_ = 0;         ///< heartbeats since anything came
    std::uint64_t missing_ = 0;  ///< replies that did not come, and messages that nobody fetched
    std::uint64_t unreadable_ = 0;
    std::uint64_t lostEvents_ = 0;
    Time lostAt_{0};
    FaultLog log_;
};

}  // namespace planewright
