// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <chrono>
#include <deque>
#include <mutex>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "devices/clock.h"
#include "devices/dynamixel/packet.h"
#include "devices/laser.h"
#include "devices/transport/transport.h"

namespace planewright {

/// A question to one servo.
struct ServoQuestion {
    DynamixelPacket request;
    std::optional<std::size_t> data;       ///< bytes of data that the answer has; empty: any number
    bool isAnswered = true;                ///< false where the servo is set to say nothing to it
    bool waitsToTheEnd = false;            ///< goes on listening after the answer: does another one come?
    std::chrono::nanoseconds patience{0};  ///< listens so much longer where no sound answer has come in time
};

/// What came of one question.
struct ServoReply {
    enum class Kind {
        Answered,
        Silent,       ///< nothing came in time
        Damaged,      ///< bytes came, and no sound answer
        OtherNumber,  ///< a servo of another number answered
        Echo,         ///< answered, and our own bytes came back where they must not
    };
    Kind kind = Kind::Silent;
    DynamixelStatus status;                   ///< of the answer
    std::chrono::nanoseconds asked{0};        ///< when the question was handed over
    std::chrono::nanoseconds arrived{0};      ///< when the answer had come
    std::chrono::nanoseconds measured{0};     ///< when the servo looked: see DynamixelBus::ask()
    std::chrono::nanoseconds uncertainty{0};  ///< of that
    bool isTooLate = false;                   ///< answered, but later than is waited for without patience
    bool heardEcho = false;                   ///< our own bytes came back
    int answers = 0;                          ///< sound answers of this number
    int otherNumber = -1;                     ///< the number of a servo that answered in its place
    std::vector<std::uint8_t> heard;          ///< the first bytes that came for it, FaultLog::kMostBytes at most
};

/// Question and answer on a half duplex bus. One thread at a time; health() may be called by any.
class DynamixelBus {
public:
    struct Settings {
        std::uint8_t id = 1;
        int baud = 57'142;                    ///< for times alone: the transport has set it
        std::chrono::nanoseconds latency{0};  ///< longest time that the adapter keeps bytes back
    };

    DynamixelBus(Transport& transport, const Clock& clock, const Settings& settings);

    void setProtocol(DynamixelProtocol protocol) { protocol_ = protocol; }
    /// Time that the servo waits before it answers.
    void setReturnDelay(std::chrono::nanoseconds delay) { returnDelay_ = delay; }

    /// Asks once. What came before is thrown away first; bytes of our own that come back are left out. An answer with
    /// the wrong number of bytes is one to an earlier question and is not taken.
    ///
    /// The moment of the measurement lies between the arrival of the question at the servo and the departure of its
    /// answer, of which both are known by the time that bytes take: the middle of these, with half their distance as
    /// its uncertainty.
    ///
    /// Waits as long as the bytes take, the return delay, twice the latency and 10 ms, and the question's patience.
    /// Errors (DeviceLost): those of
    /// the transport.
    Result<ServoReply> ask(const ServoQuestion& question);

    /// Listens for a time and throws away what comes.
    Result<void> pause(std::chrono::nanoseconds time, const std::stop_token& stop);

    /// Counts from 0 again, with an empty log.
    void restartCounts();
    /// Counts an answer whose moment is too uncertain to be used.
    void countLate();

    LinkHealth health() const;
    FaultLog& log() { return log_; }
    std::string name() const { return transport_.name(); }

private:
    using Time = std::chrono::nanoseconds;

    Time transferTime(std::size_t bytes) const;
    Result<void> purge();
    Result<void> listen(const ServoQuestion& question, std::span<const std::uint8_t> sent, ServoReply& reply);
    void take(const ServoQuestion& question, const DynamixelPacket& packet, Time arrived, ServoReply& reply) const;
    void finish(std::size_t sentBytes, ServoReply& reply) const;
    void count(const ServoReply& reply);
    void logFault(const ServoReply& reply, std::span<const std::uint8_t> sent);

    Transport& transport_;
    const Clock& clock_;
    Settings settings_;
    DynamixelProtocol protocol_ = DynamixelProtocol::One;
    Time returnDelay_;
    std::uint64_t overruns_ = 0;  ///< of the transport, that are in the log

    mutable std::mutex mutex_;  ///< over what follows
    LinkHealth health_;
    std::deque<Time> answered_;  ///< answers of the last second
    FaultLog log_;
};

}  // namespace planewright
