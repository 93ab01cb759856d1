// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>

#include "core/types/angle_text.h"
#include "devices/dynamixel/dynamixel_tilt.h"
#include "devices/dynamixel/requests.h"

namespace planewright {

namespace {

/// A region's bytes with a register's value in its place.
void put(std::vector<std::uint8_t>& bytes, ServoRegion region, const ServoRegister& place, int value)
{
    const std::vector<std::uint8_t> some = littleEndian(static_cast<std::uint32_t>(value), place.size);
    std::copy(some.begin(), some.end(), bytes.begin() + (place.address - region.first));
}

std::string percent(double fraction)
{
    return fixedText(100.0 * fraction, 0) + " %";
}

}  // namespace

Result<ServoReply> DynamixelTilt::need(Result<ServoReply> reply, ErrorCode code)
{
    if (reply && reply->kind == ServoReply::Kind::Answered)
        return reply;
    const Error error = reply ? link_.failure(*reply, code) : reply.error();
    if (error.code == ErrorCode::DeviceLost || error.code == ErrorCode::Internal) {
        isArmed_ = false;
        mayHaveReset_ = true;
        share([&](Shared& shared) {
            shared.trouble = error.message;
            shared.troubleCode = ErrorCode::DeviceLost;
        });
    }
    return tl::unexpected(error);
}

Result<ServoDrive> DynamixelTilt::readDrive()
{
    for (const ServoRegion region : model_->table->drive) {
        if (const auto reply = need(link_.read(region, image_), ErrorCode::DeviceLost); !reply)
            return tl::unexpected(reply.error());
    }
    const ServoDrive drive = decodeDrive(*model_, image_);
    share([&](Shared& shared) { shared.torqueOn = drive.torqueOn; });
    return drive;
}

Result<ServoState> DynamixelTilt::readState()
{
    const auto reply = need(link_.readState(*model_->table, image_), ErrorCode::DeviceLost);
    if (!reply)
        return tl::unexpected(reply.error());
    const ServoState state = decodeState(*model_, image_, shared().torqueOn);
    noteState(state, reply->measured, true);
    if (const auto sound = checkAlarm(*reply); !sound)
        return tl::unexpected(sound.error());
    return state;
}

Result<void> DynamixelTilt::writeMotion(int goal, int speed)
{
    const ServoRegion region = model_->table->motion;
    std::vector<std::uint8_t> bytes(region.count);
    put(bytes, region, model_->table->goal, goal);
    put(bytes, region, model_->table->speed, speed);
    const HowToAsk how{false, 3, [this] { return isArmed_ && !isHeld(); }};
    // Before it is sent: it may have been obeyed even where the answer is lost.
    share([&](Shared& shared) { shared.goal = goal; });
    const auto reply = need(write(shared(), region, bytes, how), ErrorCode::DeviceLost);
    if (!reply)
        return tl::unexpected(reply.error());
    return checkAlarm(*reply);
}

Result<void> DynamixelTilt::writeGoal(int goal)
{
    const int allowed = std::clamp(goal, settings_.lowestGoal, settings_.highestGoal);
    share([&](Shared& shared) { shared.goal = allowed; });
    return writeRegister(model_->table->goal, static_cast<std::uint32_t>(allowed));
}

Result<void> DynamixelTilt::writeRegister(const ServoRegister& place, std::uint32_t value)
{
    const auto reply =
        need(write(shared(), {place.address, place.size}, littleEndian(value, place.size), {}), ErrorCode::DeviceLost);
    if (!reply)
        return tl::unexpected(reply.error());
    return {};
}

Result<ServoReply> DynamixelTilt::write(const Shared& known, ServoRegion region, std::span<const std::uint8_t> bytes,
                                        const HowToAsk& how)
{
    if (known.settings.returnLevel >= 2)
        return link_.write(region.first, bytes, true, how);
    // In 1.0 an answer with two bytes looks like its own question.
    const bool isOne = known.model->protocol == DynamixelProtocol::One;
    const ServoRegion back{region.first, isOne ? std::max<std::uint16_t>(region.count, 3) : region.count};
    Result<ServoReply> reply;
    for (int i = 0; i < how.tries; ++i) {
        if (auto sent = link_.write(region.first, bytes, false, how); !sent)
            return sent;
        RegisterImage image;
        reply = link_.read(back, image, {how.isUrgent, how.tries, {}});
        if (!reply || reply->kind != ServoReply::Kind::Answered)
            return reply;
        const std::span<const std::uint8_t> now = image.bytes(region.first, region.count);
        if (std::equal(now.begin(), now.end(), bytes.begin(), bytes.end()))
            return reply;
    }
    reply->kind = ServoReply::Kind::Silent;
    return reply;
}

Result<void> DynamixelTilt::checkAlarm(const ServoReply& reply)
{
    const StatusError error = decodeStatusError(model_->protocol, reply.status.error);
    if (!error.hasAlarm) {
        lastAlarm_.reset();
        return {};
    }
    if (model_->protocol == DynamixelProtocol::One)
        return raiseAlarm(error.alarm, reply);
    const Result<ServoDrive> drive = readDrive();
    if (!drive)
        return tl::unexpected(drive.error());
    return raiseAlarm(drive->alarm, reply);
}

/// Ends the motion. Where the alarm has not turned it off, it is told to stay where it is; nothing turns it on again.
tl::unexpected<Error> DynamixelTilt::raiseAlarm(const ServoAlarm& alarm, const ServoReply& told)
{
    const std::string what = "reports an alarm (" + (alarm.any() ? alarm.text() : std::string{"unknown"}) + ")";
    const bool turnsOff = (alarmBits(model_->protocol, alarm) & alarmBits(model_->protocol, settings_.shutdown)) != 0;
    const std::string then = turnsOff ? ". It has turned itself off; see to the cause, then recover it"
                                      : ". It was told to stay where it is; see to the cause, then arm it again";
    isArmed_ = false;
    const bool isNews = lastAlarm_ != alarm;
    if (isNews) {
        lastAlarm_ = alarm;
        const Result<ServoDrive> drive = readDrive();
        const Result<ServoReply> reply = link_.readState(*model_->table, image_);
        if (drive && reply && reply->kind == ServoReply::Kind::Answered) {
            const ServoState state = decodeState(*model_, image_, drive->torqueOn);
            noteState(state, reply->measured, true);
            if (drive->torqueOn && !drive->isShutDown)
                writeGoal(state.position);
        }
    }
    return disarm(ErrorCode::NeedsOperator, isNews ? "servo-alarm" : "", withNumbers(what) + then, told.heard);
}

/// An empty `fault` was logged before.
tl::unexpected<Error> DynamixelTilt::disarm(ErrorCode code, std::string_view fault, const std::string& trouble,
                                            std::span<const std::uint8_t> bytes)
{
    isArmed_ = false;
    const std::string message = link_.subject() + " " + trouble;
    if (!fault.empty())
        link_.log().add(clock_.now(), fault, message, bytes);
    share([&](Shared& shared) {
        shared.trouble = message;
        shared.troubleCode = code;
    });
    return fail(code, message);
}

std::string DynamixelTilt::withNumbers(const std::string& what) const
{
    const Shared known = shared();
    return what + ": load " + percent(known.state.load) + ", " + fixedText(known.state.voltage, 1) + " V (allowed " +
           fixedText(known.settings.lowestVoltage, 1) + " to " + fixedText(known.settings.highestVoltage, 1) + "), " +
           fixedText(known.state.temperature, 0) + " °C (limit " + fixedText(known.settings.temperatureLimit, 0) + ")";
}

}  // namespace planewright
