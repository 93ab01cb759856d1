// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/board/board_tracker.h"

#include <cstdlib>
#include <type_traits>
#include <utility>

#include "core/types/angle_text.h"

namespace planewright {

using namespace board;

namespace {

/// More is not remembered of what nobody fetches.
constexpr std::size_t kMostSamples = 4096;
constexpr std::size_t kMostSlices = 65'536;

template <class All>
void push(All& all, std::size_t most, typename All::value_type value)
{
    if (all.size() == most)
        all.erase(all.begin());
    all.push_back(std::move(value));
}

}  // namespace

void BoardTracker::begin(const Scale& scale, int tolerance, Time latest)
{
    scale_ = scale;
    tolerance_ = tolerance;
    latest_ = latest;
    isArmed_ = false;
    isMoving_ = false;
    isReset_ = false;
    looksAtGoal_ = false;
    boardUs_ = 0;
    uptimeMs_ = 0;
    lastPosition_.reset();
}

void BoardTracker::setArmed(std::uint64_t order)
{
    isArmed_ = true;
    isMoving_ = false;
    looksAtGoal_ = false;
    order_ = order;
    armedOrder_ = order;
    trouble_.reset();
    notice_.clear();
}

void BoardTracker::setDisarmed()
{
    isArmed_ = false;
    isMoving_ = false;
}

void BoardTracker::setMoving(std::uint16_t seq, std::uint64_t order, std::optional<int> goal)
{
    isMoving_ = isArmed_;
    looksAtGoal_ = false;
    motion_ = seq;
    order_ = order;
    goal_ = goal;
}

void BoardTracker::take(const BoardLink::Received& received)
{
    std::visit(
        [&]<class T>(const T& known) {
            if constexpr (requires { takeOne(known, received); })
                takeOne(known, received);
        },
        received.message);
}

std::optional<TiltSample> BoardTracker::takeSample()
{
    if (samples_.empty())
        return std::nullopt;
    const TiltSample sample = samples_.front();
    samples_.pop_front();
    return sample;
}

std::vector<BoardSlice> BoardTracker::takeSlices()
{
    return std::exchange(slices_, {});
}

std::optional<BoardTrouble> BoardTracker::takeTrouble()
{
    return std::exchange(trouble_, std::nullopt);
}

bool BoardTracker::takeReset()
{
    return std::exchange(isReset_, false);
}

void BoardTracker::takeOne(const HeartbeatReply& reply, const BoardLink::Received& received)
{
    // Two that reach the board together are both received before it has sent the first reply.
    if (reply.receivedUs < boardUs_)
        restart();
    boardUs_ = reply.receivedUs;
    look(reply.state, reply.fault, received.order);
}

void BoardTracker::takeOne(const StatusReply& reply, const BoardLink::Received& received)
{
    if (reply.uptimeMs < uptimeMs_)
        restart();
    uptimeMs_ = reply.uptimeMs;
    motor_.load = reply.load / 1000.0;
    motor_.voltage = reply.voltMv / 1000.0;
    motor_.temperature = reply.tempC == -128 ? std::nullopt : std::optional{1.0 * reply.tempC};
    if (reply.fault == Fault::None || static_cast<int>(reply.fault) < 0x10)
        motor_.trouble.clear();
    else
        motor_.trouble = toText(reply.fault);
    look(reply.state, reply.fault, received.order);
}

void BoardTracker::takeOne(const PositionEvent& event, const BoardLink::Received& received)
{
    if (!received.happened)
        return;
    if (*received.happened <= lastSampleAt_) {
        ++outOfOrder_;
        return;
    }
    if (received.at - *received.happened > latest_)
        ++late_;
    if (std::exchange(looksAtGoal_, false) && goal_ && std::abs(event.pos - *goal_) > tolerance_ + 1) {
        disarm({"board-slip", "says that it has arrived, but the angle it measures is " +
                                  degreesText(std::abs(event.pos - *goal_) * scale_.step(), 2) +
                                  " away from where it was to go; look whether the motor or its horn slips"});
    }
    const bool hasMoved = lastPosition_ && std::abs(event.pos - *lastPosition_) > 1;
    lastPosition_ = event.pos;
    lastSampleAt_ = *received.happened;
    push(samples_, kMostSamples,
         {*received.happened, scale_.pitch(event.pos), isMoving_ || hasMoved, received.uncertainty});
}

void BoardTracker::takeOne(const SliceEvent& event, const BoardLink::Received& received)
{
    if (!received.happened)
        return;
    notice_.clear();
    push(slices_, kMostSlices,
         {event.slice, *received.happened, scale_.pitch(event.pos), scale_.pitch(event.pos + event.moved),
          event.err != 0});
}

void BoardTracker::takeOne(const ArrivedEvent& event, const BoardLink::Received& received)
{
    if (received.order > order_ && event.request == motion_)
        arrive();
}

void BoardTracker::takeOne(const FaultEvent& event, const BoardLink::Received& received)
{
    if (received.order < armedOrder_)
        return;
    if (event.state == State::Stopped || event.state == State::Fault)
        disarm({codeOf(event.code), "reports: " + toText(event.code), event.state == State::Fault});
    else
        notice_ = toText(event.code);
}

void BoardTracker::takeOne(const LimitEvent& event, const BoardLink::Received& received)
{
    if (received.order < armedOrder_)
        return;
    disarm({"board-limit", "stopped the motor " + degreesText(std::abs(event.pos - event.limit) * scale_.step(), 2) +
                               " beyond its limit; look what pushed it there"});
}

/// What a state means that the board told of after it was last told to change it.
void BoardTracker::look(State state, Fault fault, std::uint64_t order)
{
    if (order < order_ || !isArmed_)
        return;
    switch (state) {
        case State::Armed:
            if (isMoving_)
                arrive();  // the event was lost
            break;
        case State::Moving:
        case State::Sweeping:
            break;
        case State::Unarmed:
            disarm({"board-disarmed", "was disarmed, by another program or by a start of its own"});
            break;
        case State::Stopped:
        case State::Fault:
            disarm({codeOf(fault),
                    fault == Fault::None ? "was stopped by another program" : "reports: " + toText(fault),
                    state == State::Fault});
            break;
        case State::Estopped:
            disarm({"board-estop", "was stopped in an emergency, by its button or by another program", true});
            break;
    }
}

void BoardTracker::arrive()
{
    isMoving_ = false;
    looksAtGoal_ = goal_.has_value();
}

void BoardTracker::restart()
{
    isReset_ = true;
    isMoving_ = false;
    isArmed_ = false;
    trouble_ = BoardTrouble{"board-reset", "has started anew"};
}

void BoardTracker::disarm(BoardTrouble why)
{
    isMoving_ = false;
    if (std::exchange(isArmed_, false))
        trouble_ = std::move(why);
}

}  // namespace planewright
