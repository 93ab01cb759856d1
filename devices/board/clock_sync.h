// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <chrono>
#include <cstdint>
#include <deque>
#include <optional>

namespace planewright::board {

/// Four moments of one heartbeat.
struct HeartbeatStamps {
    std::chrono::nanoseconds hostSent{0};        ///< host clock
    std::chrono::microseconds boardReceived{0};  ///< board clock
    std::chrono::microseconds boardSent{0};
    std::chrono::nanoseconds hostReceived{0};
};

/// Puts a board's clock beside the host's.
///
/// Of every half second it keeps the heartbeat with the smallest round trip, twenty in all; it takes those that were
/// about as quick as the quickest, and lays a line through them, since a board's clock runs up to a few thousandths too
/// fast or too slow. When all become slow, the quick ones count for a minute more. A heartbeat that took longer one way
/// than the other is wrong by at most half its round trip.
class ClockSync {
public:
    using Time = std::chrono::nanoseconds;

    /// Takes a heartbeat's stamps. False for ones that cannot be: an answer before the question, or a board that took
    /// longer than the whole.
    bool add(const HeartbeatStamps& stamps);

    bool isSynchronised() const { return !best_.empty(); }

    /// The host's time at a moment of the board; empty before the first heartbeat, and for moments more than ten
    /// minutes from the latest.
    std::optional<Time> toHost(std::uint64_t boardUs) const;

    /// The smallest round trip that is remembered.
    Time roundTrip() const;
    /// How much faster the board's clock runs than the host's: 0.001 gains a millisecond a second.
    double drift() const;

    /// Forgets everything: the board's clock began anew.
    void restart();

private:
    struct Sample {
        Time board;   ///< middle of the board's two moments
        Time offset;  ///< host minus board then
        Time roundTrip;
        Time at;  ///< host clock
    };
    Time slowest() const;
    void forget(Time now);
    void fit();

    std::deque<Sample> best_;  ///< one of each half second
    Time reference_{0};        ///< board's time at which the line is `offset_`
    Time offset_{0};
    double slope_ = 0.0;  ///< of host minus board, against the board's time
};

}  // namespace planewright::board
