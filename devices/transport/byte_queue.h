// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <mutex>
#include <optional>
#include <span>
#include <stop_token>
#include <string>

#include "core/types/error.h"
#include "devices/clock.h"
#include "devices/transport/transport.h"

namespace planewright {

/// What a transport has received, between the thread that receives and the one that reads.
///
/// A receiver never waits for the reader, so the queue grows while nobody reads; no byte is ever dropped on its way. It
/// has a limit all the same, since a device that floods a reader who is gone must not take all of the memory: beyond
/// it the link ends with an error, after what was received.
class ByteQueue {
public:
    /// Unread bytes with what the queue needs to keep them apart: four minutes of the fastest laser.
    static constexpr std::size_t kMostUnread = std::size_t{64} << 20;

    /// `name` is that of the transport, for messages.
    ByteQueue(const Clock& clock, std::string name, std::size_t mostUnread = kMostUnread);

    /// Appends bytes that have come together, now. False, and nothing kept, once the queue has ended. Any thread.
    bool push(std::span<const std::uint8_t> bytes);

    /// Nothing comes any more, for a reason. The first reason stays; the bytes before it can still be read. Any thread.
    void end(Error reason);

    /// Why it has ended; empty: it has not. Any thread.
    std::optional<Error> ended() const;

    /// Transport::read(). One thread at a time.
    Result<Transport::Arrival> read(std::span<std::uint8_t> into, std::chrono::nanoseconds deadline,
                                    const std::stop_token& stop);

private:
    struct Mark {
        std::size_t count;
        std::chrono::nanoseconds at;
    };
    Transport::Arrival take(std::span<std::uint8_t> into);

    const Clock& clock_;
    std::string name_;
    std::size_t mostUnread_;
    mutable std::mutex mutex_;
    std::condition_variable_any changed_;
    std::deque<std::uint8_t> bytes_;
    std::deque<Mark> arrivals_;  ///< how the bytes divide; never an empty one
    std::optional<Error> ended_;
};

}  // namespace planewright
