// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/dynamixel/dynamixel_tilt.h"
#include "devices/dynamixel/servo_checks.h"

namespace planewright {

namespace {

constexpr std::chrono::milliseconds kOldAnswers{50};
/// An answer that comes late must not be taken for silence, nor for one to the next question.
constexpr std::chrono::milliseconds kPatience{150};
constexpr int kPings = 2;
/// Of a link that is slower than that the line is quiet after so long, and one answer is waited for.
constexpr std::chrono::milliseconds kQuiet{400};
constexpr std::chrono::milliseconds kLongestPatience{400};

HowToAsk patiently(int tries, std::chrono::nanoseconds patience)
{
    return {false, tries, {}, patience};
}

std::uint64_t heardBy(const LinkHealth& health)
{
    return health.good + health.corrupt + health.late;
}

/// The bytes that tell model and firmware; not two, which would look like their own question.
constexpr ServoRegion identityRegion(DynamixelProtocol protocol)
{
    return protocol == DynamixelProtocol::One ? ServoRegion{0, 3} : ServoRegion{0, 7};
}

}  // namespace

Result<void> DynamixelTilt::connect(const std::stop_token& stop)
{
    isArmed_ = false;
    holdsTakenBack_ = holds_.load();
    model_ = nullptr;
    lastAlarm_.reset();
    watch_.reset();
    failures_ = 0;
    mayHaveReset_ = false;
    wasRecovered_ = false;
    share([](Shared& shared) { shared = {}; });
    Result<void> done = findAndLook(stop);
    if (!done) {
        model_ = nullptr;
        share([](Shared& shared) { shared = {}; });
    }
    return done;
}

Result<void> DynamixelTilt::findAndLook(const std::stop_token& stop)
{
    if (const auto fault = faultOf(options_.mounting))
        return fail(ErrorCode::Usage, link_.subject() + ": the mounting is wrong: " + *fault);
    const std::uint64_t heard = heardBy(link_.health());
    const Result<ServoReply> state = find(stop);
    if (!state && state.error().code == ErrorCode::NoDevice && heardBy(link_.health()) > heard) {
        // Answers to earlier questions look like damage, like two servos, and like one that does not answer.
        if (const auto quick = checkQuick(stop); !quick)
            return quick;
    }
    if (!state)
        return tl::unexpected(state.error());
    if (stop.stop_requested())
        return fail(ErrorCode::Interrupted, link_.subject() + ": connecting was stopped");
    return look(*state);
}

/// Protocol, model, and all that it says of itself; the answer with its state.
Result<ServoReply> DynamixelTilt::find(const std::stop_token& stop)
{
    if (auto found = findProtocol(stop); !found)
        return tl::unexpected(found.error());
    const Result<const DynamixelModel*> model = findModel();
    if (!model)
        return tl::unexpected(model.error());
    model_ = *model;
    return readAll();
}

/// One question in each protocol, on a line that is quiet.
Result<void> DynamixelTilt::checkQuick(const std::stop_token& stop)
{
    if (const auto quiet = link_.pause(kQuiet, stop); !quiet)
        return quiet;
    for (const DynamixelProtocol protocol : {DynamixelProtocol::One, DynamixelProtocol::Two}) {
        if (stop.stop_requested())
            return fail(ErrorCode::Interrupted, link_.subject() + ": connecting was stopped");
        link_.setProtocol(protocol);
        const Result<ServoReply> reply = link_.ping(patiently(1, kLongestPatience));
        if (!reply)
            return tl::unexpected(reply.error());
        if (auto quick = checkQuick(*reply); !quick || reply->kind == ServoReply::Kind::Answered)
            return quick;
    }
    return {};
}

/// Errors (NoDevice): it answers, and too late.
Result<void> DynamixelTilt::checkQuick(const ServoReply& reply) const
{
    if (!reply.isTooLate)
        return {};
    return fail(ErrorCode::NoDevice,
                link_.subject() + " answers too slowly: " +
                    std::to_string(std::chrono::round<std::chrono::milliseconds>(reply.arrived - reply.asked).count()) +
                    " ms after a question, and its angles must be known to 5 ms. Connect its adapter to this computer "
                    "directly, set the adapter's latency timer to 1 ms, then connect again");
}

/// Pings in 1.0, then in 2.0.
Result<void> DynamixelTilt::findProtocol(const std::stop_token& stop)
{
    // Whoever used the line before, and was killed in the middle of a question, has left an answer on its way.
    if (const auto quiet = link_.pause(kOldAnswers, stop); !quiet)
        return quiet;
    std::optional<ServoReply> best;
    for (const DynamixelProtocol protocol : {DynamixelProtocol::One, DynamixelProtocol::Two}) {
        if (stop.stop_requested())
            return fail(ErrorCode::Interrupted, link_.subject() + ": connecting was stopped");
        link_.setProtocol(protocol);
        Result<ServoReply> reply = link_.ping(patiently(kPings, kPatience));
        if (!reply)
            return tl::unexpected(reply.error());
        if (const auto quick = checkQuick(*reply); !quick)
            return quick;
        const bool isOne = reply->kind == ServoReply::Kind::Answered && reply->answers == 1;
        if (isOne && !reply->heardEcho)
            return {};
        if (isOne) {
            // A ping of 1.0 comes back the same from an adapter and from a servo whose supply is wrong: a read does
            // not.
            const Result<ServoReply> read = link_.read(identityRegion(protocol), image_);
            if (!read)
                return tl::unexpected(read.error());
            if (read->answers > 0)
                return {};
            reply = read;
        }
        // What was heard tells more than silence does.
        if (!best || best->kind == ServoReply::Kind::Silent)
            best = *reply;
        if (reply->answers > 1)
            break;
    }
    if (best->kind == ServoReply::Kind::Silent && !best->heardEcho)
        return fail(ErrorCode::NoDevice,
                    link_.subject() + " does not answer at " + std::to_string(options_.baud) +
                        " baud, neither in protocol 1.0 nor in 2.0. Check its power, its plug, its number and its rate "
                        "(new ones have number 1 and 57142, 1000000 or 57600 baud)");
    return tl::unexpected(link_.failure(*best, ErrorCode::NoDevice));
}

Result<const DynamixelModel*> DynamixelTilt::findModel()
{
    const Result<ServoReply> reply = link_.read(identityRegion(link_.protocol()), image_, patiently(kPings, kPatience));
    if (!reply)
        return tl::unexpected(reply.error());
    if (const auto quick = checkQuick(*reply); !quick)
        return tl::unexpected(quick.error());
    if (reply->kind == ServoReply::Kind::Silent && !reply->heardEcho)
        return fail(ErrorCode::NoDevice,
                    link_.subject() +
                        " answers to its number and to no question: its status return level is 0. Set it to 2 with the "
                        "manufacturer's program (address 16; 68 in protocol 2.0), then connect again");
    if (reply->kind != ServoReply::Kind::Answered)
        return tl::unexpected(link_.failure(*reply, ErrorCode::NoDevice));
    const auto number = static_cast<std::uint16_t>(image_.value({0, 2}));
    const DynamixelModel* model = findDynamixelModel(link_.protocol(), number);
    if (model == nullptr)
        return fail(ErrorCode::NoDevice, link_.subject() + " is of a model that is not known here (number " +
                                             std::to_string(number) + "). Known are " + knownDynamixelModels());
    return model;
}

/// Settings, drive and state; the answer with the state.
Result<ServoReply> DynamixelTilt::readAll()
{
    for (const std::span<const ServoRegion> regions : {model_->table->settings, model_->table->drive}) {
        for (const ServoRegion region : regions) {
            if (auto reply = need(link_.read(region, image_), ErrorCode::NoDevice); !reply)
                return reply;
        }
    }
    return need(link_.readState(*model_->table, image_), ErrorCode::NoDevice);
}

/// May it be moved? Only then does anybody else hear of it.
Result<void> DynamixelTilt::look(const ServoReply& reply)
{
    if (const auto reason = reasonNotToMove(*model_, image_))
        return fail(ErrorCode::NoDevice,
                    link_.subject() + " (" + std::string{model_->name} + ") " + *reason + ", then connect again");
    settings_ = decodeSettings(*model_, image_);
    angles_ = {*model_, options_.mounting, settings_.lowestGoal, settings_.highestGoal, settings_.mostSpeed};
    if (angles_.isEmpty())
        return fail(ErrorCode::Usage,
                    link_.subject() + ": the limits of the mounting leave nothing of what it can reach");
    link_.setReturnDelay(settings_.returnDelay);
    link_.restartCounts();  // what the search for it cost is no loss
    const ServoDrive drive = decodeDrive(*model_, image_);
    share([&](Shared& shared) {
        shared.model = model_;
        shared.settings = settings_;
        shared.torqueOn = drive.torqueOn;
        shared.goal = drive.goal;
        shared.state = decodeState(*model_, image_, drive.torqueOn);
        shared.stateAt = reply.measured;
        shared.isTrusted = true;
    });
    if (const auto sound = checkAlarm(reply); !sound)
        return {};  // arm() refuses, and recover() needs a servo that is connected
    if (drive.isShutDown) {
        disarm(ErrorCode::NeedsOperator, "servo-off", "was turned off by an alarm; see to the cause, then recover it");
        return {};
    }
    return stopWhatWasLeft();
}

/// A program before this one may have died while it moved.
Result<void> DynamixelTilt::stopWhatWasLeft()
{
    const Shared known = shared();
    if (known.torqueOn && known.state.moving)
        return writeGoal(known.state.position);
    return {};
}

std::string DynamixelTilt::identity() const
{
    if (model_ == nullptr)
        return link_.subject();
    return std::string{model_->name} + ", number " + std::to_string(options_.id) + ", firmware " +
           std::to_string(settings_.firmware);
}

}  // namespace planewright
