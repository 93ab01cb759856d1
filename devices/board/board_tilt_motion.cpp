// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/types/angle_text.h"
#include "devices/board/board_tilt.h"

/// What a control board does once it is connected: motion, samples, slices.

namespace planewright {

using namespace board;

namespace {

using namespace std::chrono_literals;

constexpr std::chrono::nanoseconds kStatusEvery = 1s;
/// Without an angle for so long, or for so many times the time between two, there will be none.
constexpr std::chrono::nanoseconds kLongestWithoutAngle = 1s;
constexpr int kMissingAngles = 3;

std::string whyItStarted(std::uint8_t reset)
{
    switch (reset) {
        case 0:
            return "its power was off";
        case 1:
            return "its button was pressed";
        case 2:
            return "its voltage fell";
        case 3:
            return "its own watchdog found it hanging";
        default:
            return "it does not say why";
    }
}

}  // namespace

Result<void> BoardTilt::moveTo(double pitch, double speed)
{
    const Result<int> goal = countsOf(pitch);
    if (!goal)
        return tl::unexpected(goal.error());
    const Result<int> fast = countsASecond(speed);
    if (!fast)
        return tl::unexpected(fast.error());
    if (Result<void> may = mayMove(); !may)
        return may;
    return begin(Move{static_cast<std::uint16_t>(*goal), static_cast<std::uint16_t>(*fast), 1, 0}, *goal);
}

Result<void> BoardTilt::goHome()
{
    if (Result<void> may = mayMove(); !may)
        return may;
    return begin(Home{}, scale_.nearest(home()));
}

Result<void> BoardTilt::sweep(const BoardSweep& plan)
{
    const Result<int> first = countsOf(plan.first);
    const Result<int> last = countsOf(plan.last);
    const Result<int> fast = countsASecond(plan.speed);
    if (!first || !last || !fast)
        return tl::unexpected(!first ? first.error() : !last ? last.error() : fast.error());
    const double step = std::round(plan.step / scale_.step());
    const double way = std::abs(*last - *first);
    if (!(step >= 1.0) || plan.slices < 1 || plan.slices > 65'535 || (plan.slices - 1) * step > way)
        return failure(ErrorCode::Usage, std::to_string(plan.slices) + " slices at steps of " +
                                             degreesText(plan.step, 2) + " do not fit between " +
                                             degreesText(plan.first, 2) + " and " + degreesText(plan.last, 2));
    if (Result<void> may = mayMove(); !may)
        return may;
    Sweep request;
    request.first = static_cast<std::uint16_t>(*first);
    request.last = static_cast<std::uint16_t>(*last);
    request.step = static_cast<std::uint16_t>(step);
    request.slices = static_cast<std::uint16_t>(plan.slices);
    request.mode = plan.isContinuous ? 1 : 0;
    request.speed = static_cast<std::uint16_t>(*fast);
    request.firstSlice = plan.firstNumber;
    return begin(request, std::nullopt);
}

Result<void> BoardTilt::stop()
{
    tracker_.setDisarmed();
    const Result<Received> reply = ask(Stop{}, {});
    return reply ? Result<void>{} : tl::unexpected(reply.error());
}

Result<void> BoardTilt::trigger(std::uint32_t number)
{
    const Result<Received> reply = ask(Trigger{number}, {});
    if (!reply)
        return tl::unexpected(reply.error());
    if (const auto* nak = std::get_if<Nak>(&reply->message))
        return failure(ErrorCode::Usage,
                       "takes no angle for slice " + std::to_string(number) + ": " + toText(nak->code));
    return {};
}

Result<std::optional<TiltSample>> BoardTilt::sample(std::chrono::nanoseconds deadline, const std::stop_token& stop)
{
    if (!isConnected_)
        return failure(ErrorCode::NoDevice, "is not connected");
    if (!isConfigured_) {
        if (const Result<void> greeted = greet(link_.patience(), stop); !greeted)
            return tl::unexpected(greeted.error());
    }
    if (!waitsSince_)
        waitsSince_ = clock_.now();
    for (;;) {
        if (const auto sample = tracker_.takeSample()) {
            waitsSince_.reset();
            return sample;
        }
        if (clock_.now() >= nextStatus_) {
            if (const Result<void> asked = askForStatus(); !asked)
                return tl::unexpected(asked.error());
        }
        const auto until = std::min({deadline, nextStatus_, *waitsSince_ + longestWithoutAngle()});
        const Result<std::optional<Received>> received = link_.next(until, stop);
        if (!received)
            return lost(received.error());
        if (*received) {
            if (isHeld_)
                tracker_.setDisarmed();  // that it is stopped then is no trouble
            tracker_.take(**received);
            publish();
            if (const Result<void> fine = reportTrouble(stop); !fine)
                return tl::unexpected(fine.error());
        } else if (const Result<void> angles = mustGiveAngles(); !angles) {
            return tl::unexpected(angles.error());
        } else if (clock_.now() >= deadline || stop.stop_requested()) {
            return std::nullopt;
        }
    }
}

std::chrono::nanoseconds BoardTilt::longestWithoutAngle() const
{
    return std::max(kLongestWithoutAngle, kMissingAngles * std::chrono::nanoseconds{1s} / options_.positionRate);
}

/// A board whose angles have no moment, or that tells none, is of no use: that must not look like patience.
Result<void> BoardTilt::mustGiveAngles()
{
    if (clock_.now() < *waitsSince_ + longestWithoutAngle())
        return {};
    waitsSince_.reset();
    const std::string slowness = link_.slowness();
    const std::string what = slowness.empty() ? "sends no angles any more; unplug it and plug it in again" : slowness;
    link_.log().add(clock_.now(), slowness.empty() ? "board-no-angles" : "board-slow", what);
    return lost(failure(ErrorCode::DeviceLost, what).value());
}

Result<void> BoardTilt::begin(const Message& motion, std::optional<int> goal)
{
    const Result<Received> reply = askUnlessHeld(motion, {});
    if (!reply)
        return reply.error().code == ErrorCode::DeviceLost ? lost(reply.error()) : tl::unexpected(reply.error());
    if (const auto* nak = std::get_if<Nak>(&reply->message)) {
        if (nak->code == NakCode::Estopped && isHeld_)
            return failure(ErrorCode::Interrupted, "is held; arm it before it moves");
        if (nak->code == NakCode::Range)
            return failure(ErrorCode::Usage, "refuses to move there: " + toText(nak->code));
        const auto state = static_cast<State>(nak->detail);
        // It was armed, and is not: nobody but a person knows why.
        const bool isStopped = nak->code == NakCode::Estopped || nak->code == NakCode::State;
        const bool isLatched = nak->code == NakCode::Estopped || state == State::Estopped || state == State::Fault;
        return failure(isStopped ? ErrorCode::NeedsOperator : ErrorCode::DeviceLost,
                       "does not move: " + toText(nak->code) + " (" + toText(state) + "); " +
                           (isLatched ? "see to the cause, then recover it" : "look why, then arm it again"));
    }
    tracker_.setMoving(reply->seq, reply->order, goal);
    return {};
}

/// Whether it may move at all; takes what has come meanwhile into account.
Result<void> BoardTilt::mayMove()
{
    if (!isConnected_)
        return failure(ErrorCode::NoDevice, "is not connected");
    if (Result<void> drained = drain(); !drained)
        return drained;
    if (Result<void> held = notHeld(); !held)
        return held;
    if (Result<void> fine = reportTrouble({}); !fine)
        return fine;
    if (tracker_.isArmed())
        return {};
    const std::scoped_lock lock(shown_);
    return failure(trouble_.empty() ? ErrorCode::Usage : troubleCode_,
                   "is not armed; arm it before it moves" + (trouble_.empty() ? "" : ". Before: " + trouble_));
}

Result<void> BoardTilt::notHeld() const
{
    if (isHeld_)
        return failure(ErrorCode::Interrupted, "is held; arm it before it moves");
    return {};
}

Result<BoardTilt::Received> BoardTilt::ask(const Message& request, const std::stop_token& stop)
{
    return link_.ask(link_.prepare(request), {}, link_.patience(), stop);
}

Result<BoardTilt::Received> BoardTilt::askUnlessHeld(const Message& request, const std::stop_token& stop)
{
    return link_.ask(
        link_.prepare(request), [this] { return notHeld(); }, link_.patience(), stop);
}

Result<int> BoardTilt::countsOf(double pitch) const
{
    // The mounting's limits lie up to a step beyond those that the board can have.
    if (!(pitch >= lowest() - scale_.step() && pitch <= highest() + scale_.step()))
        return failure(ErrorCode::Usage, degreesText(pitch, 2) + " is beyond its limits, " + degreesText(lowest(), 2) +
                                             " to " + degreesText(highest(), 2));
    return scale_.nearest(pitch);
}

Result<int> BoardTilt::countsASecond(double speed) const
{
    if (!(speed > 0.0 && speed <= fastest() + scale_.step()))
        return failure(ErrorCode::Usage, degreesText(speed, 2) + " a second is no speed for it; it moves with up to " +
                                             degreesText(fastest(), 2) + " a second");
    return std::clamp(static_cast<int>(std::lround(speed / scale_.step())), 1, scale_.topSpeed());
}

/// Takes what is there already.
Result<void> BoardTilt::drain()
{
    for (;;) {
        const Result<std::optional<Received>> received = link_.next(clock_.now(), {});
        if (!received)
            return lost(received.error());
        if (!*received)
            break;
        tracker_.take(**received);
    }
    publish();
    return {};
}

Result<void> BoardTilt::askForStatus()
{
    nextStatus_ = clock_.now() + kStatusEvery;
    return link_.post(GetStatus{});
}

/// What stopped the motor, once. A board that has started anew is greeted again, and waits to be armed.
Result<void> BoardTilt::reportTrouble(const std::stop_token& stop)
{
    std::optional<BoardTrouble> what = tracker_.takeTrouble();
    if (!what)
        return {};
    if (tracker_.takeReset()) {
        if (Result<void> greeted = greet(link_.patience(), stop); !greeted)
            return greeted;
        what->text += ": " + std::string{whyItStarted(board_.reset)};
    }
    link_.log().add(clock_.now(), what->code, what->text);
    what->text += what->isLatched ? "; see to the cause, then recover it" : "; look why, then arm it again to go on";
    if (what->isEstop()) {
        const std::scoped_lock lock(holding_);
        isStopped_ = true;
    }
    const std::scoped_lock lock(shown_);
    trouble_ = what->text;
    troubleCode_ = ErrorCode::NeedsOperator;
    return failure(ErrorCode::NeedsOperator, what->text);
}

tl::unexpected<Error> BoardTilt::lost(const Error& why)
{
    tracker_.setDisarmed();
    const std::scoped_lock lock(shown_);
    trouble_ = why.message;
    troubleCode_ = why.code;
    return tl::unexpected(why);
}

void BoardTilt::publish()
{
    const std::scoped_lock lock(shown_);
    shownMotor_ = tracker_.motor();
    late_ = tracker_.late();
    outOfOrder_ = tracker_.outOfOrder();
    notice_ = tracker_.notice();
}

}  // namespace planewright
