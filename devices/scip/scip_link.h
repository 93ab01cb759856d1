// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <chrono>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>

#include "core/types/error.h"
#include "devices/clock.h"
#include "devices/scip/scip_decoder.h"
#include "devices/transport/transport.h"

namespace planewright {

/// As long as a reply takes at most.
inline constexpr std::chrono::milliseconds kScipReply{500};

/// What came, and when its last byte had come.
struct ScipArrival {
    ScipEvent event;
    std::chrono::nanoseconds at{0};
};

/// A reply to what was asked.
struct ScipAnswer : ScipReply {
    std::chrono::nanoseconds asked{0};     ///< when the request was sent
    std::chrono::nanoseconds answered{0};  ///< when the last byte of the reply had come
};

/// A laser at the end of a transport: requests out, events in. Used by one thread.
class ScipLink {
public:
    using Time = std::chrono::nanoseconds;

    ScipLink(std::unique_ptr<Transport> transport, const Clock& clock);

    std::string name() const { return transport_->name(); }
    Time now() const { return clock_.now(); }

    /// Sends a request and its line feed. Errors: those of the transport.
    Result<void> send(std::string_view request);

    /// The next event; empty where none is complete before the deadline or a stop. Errors: those of the transport.
    Result<std::optional<ScipArrival>> next(Time deadline, const std::stop_token& stop);

    /// Sends a request and waits for the reply with the same echo; whatever else comes meanwhile is thrown away. Empty
    /// where there is none in time. Errors: those of the transport.
    Result<std::optional<ScipAnswer>> ask(std::string_view request, Time patience, const std::stop_token& stop);

    /// Kinds of things that came.
    struct Heard {
        bool anything = false;  ///< bytes
        bool scans = false;
        bool replies = false;
    };
    /// Throws away what comes, until nothing has come for `silence`, at most for `longest`, or until a stop. With
    /// `silence` as long as `longest` it is a wait.
    Result<Heard> discard(Time silence, Time longest, const std::stop_token& stop);

    /// Everything heard so far.
    const Heard& heard() const { return heard_; }

    void close() { transport_->close(); }
    /// Any thread.
    TransportHealth transportHealth() const { return transport_->health(); }

private:
    Result<bool> readMore(Time deadline, const std::stop_token& stop);

    std::unique_ptr<Transport> transport_;
    const Clock& clock_;
    ScipDecoder decoder_;
    std::deque<ScipArrival> arrived_;
    Heard heard_;
};

}  // namespace planewright
