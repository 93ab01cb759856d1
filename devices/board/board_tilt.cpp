// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/board/board_tilt.h"

#include <algorithm>
#include <utility>

namespace planewright {

using namespace board;

namespace {

using namespace std::chrono_literals;

constexpr int kFirstHeartbeats = 8;
/// A sample is late when it comes more than this and a period after its moment.
constexpr std::chrono::nanoseconds kOnTheWay = 5ms;

std::string firmwareOf(const HelloReply& board)
{
    return std::to_string(board.firmware >> 8) + '.' + std::to_string(board.firmware & 0xFF);
}

}  // namespace

BoardTilt::BoardTilt(std::unique_ptr<Transport> transport, const Clock& clock, const BoardTiltOptions& options)
    : options_(options), clock_(clock), link_(std::move(transport), clock, options.timing), scale_(options.mounting)
{
}

Result<void> BoardTilt::connect(const std::stop_token& stop)
{
    isConnected_ = false;
    link_.setBeating(false);
    if (Result<void> empty = link_.beginAnew(); !empty)
        return empty;
    const BoardTiming& timing = options_.timing;
    if (Result<void> greeted = greet({timing.firstReply, timing.firstTries}, stop); !greeted)
        return greeted;
    const Result<Received> status = ask(GetStatus{}, stop);
    if (!status)
        return tl::unexpected(status.error());
    tracker_.take(*status);
    publish();
    const StatusReply reply = statusOf(*status);
    const std::scoped_lock lock(holding_);
    // One that was stopped in an emergency before must not be stopped once more, which would make it limp.
    isStopped_ = reply.state == State::Estopped;
    isHeldByUs_ = false;
    waitsSince_.reset();
    isConnected_ = true;
    return {};
}

/// A session from its beginning: HELLO, limits, clocks. The board moves nothing after it.
Result<void> BoardTilt::greet(BoardLink::Patience patience, const std::stop_token& stop)
{
    isConfigured_ = false;
    const Result<std::optional<Received>> hello = link_.tryToAsk(link_.prepare(Hello{}), {}, patience, stop);
    if (!hello)
        return tl::unexpected(hello.error());
    if (!*hello && !isConnected_)
        return failure(ErrorCode::NoDevice,
                       "nothing answers there as a board that speaks NTB/1 does; check its cable, "
                       "its power and its firmware");
    if (!*hello)
        return failure(ErrorCode::DeviceLost, "does not answer any more; check its cable and power");
    const auto* reply = std::get_if<HelloReply>(&(*hello)->message);
    if (reply == nullptr || reply->proto != kVersion)
        return failure(ErrorCode::NoDevice,
                       "speaks another version of its protocol; program it with a firmware for "
                       "NTB/1");
    if (Result<void> introduced = introduce(*reply); !introduced)
        return introduced;
    if (Result<void> configured = configure(stop); !configured)
        return configured;
    return compareClocks(stop);
}

/// Takes over who it is, and what its servo can do.
Result<void> BoardTilt::introduce(const HelloReply& board)
{
    const Result<Scale> scale = Scale::of(board, options_.mounting);
    if (!scale)
        return failure(scale.error().code, scale.error().message);
    board_ = board;
    scale_ = *scale;
    std::string serial = toHex(board.serial);
    std::erase(serial, ' ');
    identity_ = "control board " + serial + ", firmware " + firmwareOf(board) + ", " + servoName(board.servoModel);
    tracker_.begin(scale_, options_.tolerance, std::chrono::nanoseconds{1s} / options_.positionRate + kOnTheWay);
    return {};
}

Result<void> BoardTilt::configure(const std::stop_token& stop)
{
    SetConfig config;
    config.low = static_cast<std::uint16_t>(scale_.low());
    config.high = static_cast<std::uint16_t>(scale_.high());
    config.topSpeed = static_cast<std::uint16_t>(scale_.topSpeed());
    config.park = static_cast<std::uint16_t>(scale_.nearest(home()));
    config.parkSpeed = static_cast<std::uint16_t>(
        std::clamp(static_cast<int>(std::lround(homeSpeed() / scale_.step())), 1, scale_.topSpeed()));
    config.tolerance = static_cast<std::uint8_t>(options_.tolerance);
    config.settleMs = static_cast<std::uint16_t>(options_.settle.count());
    config.heartbeatMs = static_cast<std::uint16_t>(options_.watchdog.count());
    config.scanUs = static_cast<std::uint16_t>(options_.scanTime.count());
    config.positionHz = static_cast<std::uint8_t>(options_.positionRate);
    const Result<Received> reply = ask(config, stop);
    if (!reply)
        return tl::unexpected(reply.error());
    const auto* now = std::get_if<SetConfigReply>(&reply->message);
    if (now == nullptr || static_cast<const Config&>(*now) != config)
        return failure(ErrorCode::NoDevice, "does not take the limits of the mounting; its own are narrower");
    isConfigured_ = true;
    return {};
}

Result<void> BoardTilt::compareClocks(const std::stop_token& stop)
{
    link_.setBeating(true);
    for (int i = 0; i < kFirstHeartbeats; ++i) {
        if (Result<void> compared = link_.synchronise(stop); !compared)
            return compared;
    }
    return {};
}

Result<void> BoardTilt::arm(const std::stop_token& stop)
{
    if (!isConnected_)
        return failure(ErrorCode::NoDevice, "is not connected");
    isHeld_ = false;
    tracker_.setDisarmed();
    if (Result<void> takenBack = takeBackHold(stop); !takenBack)
        return takenBack;
    if (!isConfigured_) {
        if (Result<void> greeted = greet(link_.patience(), stop); !greeted)
            return greeted;
    }
    if (Result<void> drained = drain(); !drained)
        return drained;
    if (Result<void> free = mustNotWaitForAnybody(stop); !free)
        return free;
    if (Result<void> beaten = link_.synchronise(stop); !beaten)
        return beaten;
    return sendArm(stop);
}

/// After an ESTOP without an answer: whether it came is not known, and done twice it would take the torque away.
Result<void> BoardTilt::learnFateOfHold(const std::stop_token& stop)
{
    if (!estop_)
        return {};
    const Result<Received> answered = link_.ask(*estop_, {}, link_.patience(), stop);
    if (!answered)
        return tl::unexpected(answered.error());
    estop_.reset();
    isStopped_ = true;
    isHeldByUs_ = true;
    return {};
}

/// Ends an emergency stop of ours. Who stops meanwhile waits until that is over, so that his stop is the first one
/// again.
Result<void> BoardTilt::takeBackHold(const std::stop_token& stop)
{
    const std::scoped_lock lock(holding_);
    if (Result<void> known = learnFateOfHold(stop); !known)
        return known;
    link_.setBeating(true);
    return isStopped_ && isHeldByUs_ ? clear(stop) : Result<void>{};
}

Result<StatusReply> BoardTilt::readStatus(const std::stop_token& stop)
{
    const Result<Received> status = ask(GetStatus{}, stop);
    if (!status)
        return tl::unexpected(status.error());
    return statusOf(*status);
}

StatusReply BoardTilt::statusOf(const Received& answer)
{
    const auto* const reply = std::get_if<StatusReply>(&answer.message);
    if (reply == nullptr)
        return {};
    startedAt_ = clock_.now() - std::chrono::milliseconds{reply->uptimeMs};
    return *reply;
}

/// A board that has stopped by itself, or by its button, waits for a person.
Result<void> BoardTilt::mustNotWaitForAnybody(const std::stop_token& stop)
{
    const Result<StatusReply> status = readStatus(stop);
    if (!status)
        return tl::unexpected(status.error());
    if (status->state == State::Estopped)
        return failure(ErrorCode::NeedsOperator,
                       "was stopped in an emergency, by its button or by another program; see to the cause, then "
                       "recover it");
    if (status->state == State::Fault)
        return failure(ErrorCode::NeedsOperator,
                       "has stopped: " + toText(status->fault) + "; see to the cause, then recover it");
    // One that has started anew is not stopped any more, and a hold() must stop it again.
    const std::scoped_lock lock(holding_);
    isStopped_ = isStopped_ && isHeld_;
    return {};
}

Result<void> BoardTilt::recover(const std::stop_token& stop)
{
    if (!isConnected_)
        return failure(ErrorCode::NoDevice, "is not connected");
    const std::scoped_lock lock(holding_);
    if (Result<void> known = learnFateOfHold(stop); !known)
        return known;
    const Result<StatusReply> status = readStatus(stop);
    if (!status)
        return tl::unexpected(status.error());
    if (status->state == State::Estopped || status->state == State::Fault) {
        if (Result<void> cleared = clear(stop); !cleared)
            return cleared;
    }
    if (Result<void> drained = drain(); !drained)
        return drained;
    (void)tracker_.takeTrouble();
    const std::scoped_lock shown(shown_);
    trouble_.clear();
    return {};
}

/// CLEAR_FAULT, which a board obeys where the cause is gone.
Result<void> BoardTilt::clear(const std::stop_token& stop)
{
    const Result<Received> cleared = ask(ClearFault{}, stop);
    if (!cleared)
        return tl::unexpected(cleared.error());
    const auto* const now = std::get_if<ClearFaultReply>(&cleared->message);
    if (now != nullptr && now->state == State::Estopped)
        return failure(ErrorCode::NeedsOperator,
                       "stays stopped: its button for emergencies is still pressed; release it, then recover it again");
    if (now == nullptr || now->state == State::Fault) {
        const Result<StatusReply> status = readStatus(stop);
        return failure(ErrorCode::NeedsOperator,
                       "cannot be released: " + (status ? toText(status->fault) : status.error().message) +
                           "; see to the cause, then recover it again");
    }
    isStopped_ = false;
    isHeldByUs_ = false;
    return {};
}

Result<void> BoardTilt::sendArm(const std::stop_token& stop)
{
    Result<Received> armed = askUnlessHeld(Arm{1}, stop);
    const auto isArmed = [&] {
        const auto* reply = armed ? std::get_if<ArmReply>(&armed->message) : nullptr;
        return reply != nullptr && reply->state == State::Armed;
    };
    if (armed && !isArmed()) {
        // It was reset and knows us no more.
        if (Result<void> greeted = greet(link_.patience(), stop); !greeted)
            return greeted;
        armed = askUnlessHeld(Arm{1}, stop);
    }
    if (!armed)
        return tl::unexpected(armed.error());
    if (!isArmed())
        return failure(ErrorCode::DeviceLost, "does not let itself be armed; unplug it and plug it in again");
    tracker_.setArmed(armed->order);
    const std::scoped_lock lock(shown_);
    trouble_.clear();
    return {};
}

Result<void> BoardTilt::hold()
{
    isHeld_ = true;
    const std::scoped_lock lock(holding_);
    if (!isStopped_) {
        // Should the request be lost on its way, the missing heartbeat stops the motor.
        link_.setBeating(false);
        if (!estop_)
            estop_ = link_.prepare(Estop{});
        const Result<Received> reply = link_.ask(*estop_, {}, link_.patience(), {});
        if (!reply)
            return failure(reply.error().code, "did not answer the emergency stop: " + reply.error().message);
        estop_.reset();
        isStopped_ = true;
        isHeldByUs_ = true;
        link_.setBeating(true);
    }
    return {};
}

LinkHealth BoardTilt::health() const
{
    LinkHealth health = link_.health();
    const std::scoped_lock lock(shown_);
    health.corrupt += outOfOrder_;
    health.late = late_;
    for (const std::string& worse : {notice_, trouble_}) {
        if (!worse.empty())
            health.trouble = worse;
    }
    return health;
}

MotorState BoardTilt::motor() const
{
    const std::scoped_lock lock(shown_);
    return shownMotor_;
}

tl::unexpected<Error> BoardTilt::failure(ErrorCode code, const std::string& what) const
{
    return fail(code, "control board (" + link_.name() + "): " + what);
}

}  // namespace planewright
