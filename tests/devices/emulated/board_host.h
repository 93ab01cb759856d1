// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <vector>

#include <QtGlobal>

#include "core/types/angle.h"
#include "devices/board/frame_parser.h"
#include "devices/emulated/emulated_board.h"

namespace planewright {

/// A host written by hand that talks to an emulated board in frames, on a time of its own.
class BoardHost {
public:
    using Time = std::chrono::nanoseconds;

    explicit BoardHost(const EmulatedBoardSetup& setup) : board_(EmulatedBoard::make(setup).value()) {}

    EmulatedBoard& board() { return *board_; }
    Time now() const { return now_; }
    double pitch() { return board_->pitchAt(now_); }

    /// Sends a request and waits 5 ms for its reply.
    std::optional<board::Frame> ask(const board::Message& request) { return askWith(++seq_, request); }
    std::optional<board::Frame> askWith(int seq, const board::Message& request)
    {
        return askFrame(board::toFrame(static_cast<std::uint16_t>(seq), request));
    }
    std::optional<board::Frame> askFrame(const board::Frame& request)
    {
        sendBytes(board::encodeFrame(request));
        replies.clear();
        const Time deadline = now_ + std::chrono::milliseconds{5};
        while (now_ < deadline) {
            pass(std::chrono::microseconds{100});
            for (const board::Frame& reply : replies) {
                if (reply.seq == request.seq)
                    return reply;
            }
        }
        return std::nullopt;
    }
    /// The same, where the reply is known to be of a type.
    template <class Reply>
    Reply get(const board::Message& request)
    {
        const auto reply = ask(request);
        if (!reply)
            qFatal("the board did not answer");
        const auto message = board::toMessage(*reply);
        if (!message || !std::holds_alternative<Reply>(*message))
            qFatal("the board answered with %s", board::toText(*reply).c_str());
        return std::get<Reply>(*message);
    }

    /// HELLO, and limits 200 to 800 with at most 400 counts a second.
    void greet(int positionHz = 0)
    {
        get<board::HelloReply>(board::Hello{});
        get<board::SetConfigReply>(board::SetConfig{config(positionHz)});
    }
    void greetAndArm(int positionHz = 0)
    {
        greet(positionHz);
        get<board::ArmReply>(board::Arm{1});
        lastBeat_ = now_;
    }
    static board::Config config(int positionHz = 0)
    {
        board::Config config;
        config.low = 200;
        config.high = 800;
        config.topSpeed = 400;
        config.park = 512;
        config.parkSpeed = 100;
        config.positionHz = static_cast<std::uint8_t>(positionHz);
        return config;
    }

    /// Lets time pass, with or without heartbeats every 50 ms.
    void wait(Time time, bool beats = true)
    {
        const Time end = now_ + time;
        while (now_ < end) {
            if (beats && now_ - lastBeat_ >= std::chrono::milliseconds{50}) {
                const std::uint64_t us = static_cast<std::uint64_t>(now_.count()) / 1000;
                sendBytes(encodeFrame(board::toFrame(static_cast<std::uint16_t>(++seq_), board::Heartbeat{us})));
                lastBeat_ = now_;
            }
            pass(std::min<Time>(end - now_, std::chrono::milliseconds{1}));
        }
    }

    void sendBytes(const std::vector<std::uint8_t>& bytes) { board_->receive(bytes, now_); }

    /// Events of one kind that have come.
    template <class Event>
    std::vector<Event> all() const
    {
        std::vector<Event> found;
        for (const board::Frame& frame : events) {
            const auto message = board::toMessage(frame);
            if (message && std::holds_alternative<Event>(*message))
                found.push_back(std::get<Event>(*message));
        }
        return found;
    }

    std::vector<board::Frame> events;
    std::vector<board::Frame> replies;
    board::FrameParser parser;
    std::vector<std::uint8_t> heard;  ///< everything that came

private:
    void pass(Time time)
    {
        now_ += time;
        for (const EmulatedOutput& output : board_->takeOutput(now_)) {
            heard.insert(heard.end(), output.bytes.begin(), output.bytes.end());
            for (const board::Frame& frame : parser.push(output.bytes))
                (frame.isEvent() ? events : replies).push_back(frame);
        }
    }

    std::shared_ptr<EmulatedBoard> board_;
    Time now_{0};
    Time lastBeat_{0};
    int seq_ = 0;
};

/// A rig whose middle position looks up 90°, with sync edges at 3 ms and every 25 ms.
inline EmulatedBoardSetup levelBoard()
{
    EmulatedBoardSetup setup;
    setup.mounting.zeroPitch = degrees(90.0);
    setup.startPitch = degrees(90.0);
    setup.clockDrift = 0.0;
    setup.nextEdge = edgesEvery(std::chrono::milliseconds{25}, std::chrono::milliseconds{3});
    return setup;
}

/// φ of one count of an RX-64 [rad].
inline constexpr double kCountAngle = degrees(300.0) / 1023.0;

}  // namespace planewright
