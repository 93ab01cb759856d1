// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "devices/emulated/emulated_laser.h"
#include "devices/emulated/emulated_laser_scan.h"
#include "devices/scip/scip_encoding.h"

namespace planewright {

namespace {

constexpr std::chrono::microseconds kThinking{500};
constexpr std::chrono::seconds kRebootWithin{1};

bool isNumber(std::string_view text)
{
    return std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

int number(std::string_view digits)
{
    return std::stoi(std::string{digits});
}

std::string hexadecimal(std::uint32_t value)
{
    constexpr std::string_view kDigits = "0123456789ABCDEF";
    std::string text(6, '0');
    for (auto c = text.rbegin(); c != text.rend(); ++c, value >>= 4U)
        *c = kDigits[value & 0xFU];
    return text;
}

}  // namespace

void EmulatedLaser::answer(const std::string& line, Time now)
{
    if (speaksScip1_) {
        speaksScip1_ = line != kScipSpeak2;
        return send(line + (speaksScip1_ ? "\nE\n\n" : "\n0\n\n"), now + kThinking);
    }
    Request request{line, std::string_view{line}.substr(0, 2), {}, {}};
    const std::size_t semicolon = std::min(line.find(';'), line.size());
    request.parameters = std::string_view{line}.substr(std::min<std::size_t>(2, semicolon),
                                                       semicolon - std::min<std::size_t>(2, semicolon));
    request.tag = std::string_view{line}.substr(semicolon);

    std::erase_if(answering_, [&](const auto& reply) { return reply.second <= now; });
    const bool isAskedTwice = std::any_of(answering_.begin(), answering_.end(),
                                          [&](const auto& reply) { return reply.first == request.command; });
    if (isAskedTwice)
        return send(laserReply(line, "0B"), now + kThinking);
    if (const std::string_view mistake = mistakeIn(request); !mistake.empty())
        return send(laserReply(line, mistake), now + kThinking);
    const std::string reply = isInTimeMode_ ? replyInTimeMode(request, now) : replyTo(request, now);
    if (now < silentUntil_)
        return;
    send(reply, now + kThinking);
    answering_.emplace_back(request.command, lineFreeAt_);
}

/// Status of a request that cannot be read; empty where it can.
std::string_view EmulatedLaser::mistakeIn(const Request& request) const
{
    const bool isNew = options_.model.version() == ScipVersion::V2_2;
    const std::optional<std::size_t> length = scipParameterLength(request.command);
    if (!length || request.line == kScipSpeak2)
        return "0E";
    if (request.tag.size() > kScipTagLength + 1)
        return "0G";
    if (!request.tag.empty() && !isScipTag(request.tag.substr(1)))
        return isNew ? "0E" : "0H";
    if (request.parameters.size() < *length)
        return "0C";
    return request.parameters.size() > *length ? "0D" : std::string_view{};
}

std::string EmulatedLaser::replyInTimeMode(const Request& request, Time now)
{
    const bool isNew = options_.model.version() == ScipVersion::V2_2;
    if (request.command == kScipQuit && isNew) {
        isInTimeMode_ = false;
        return laserReply(request.line, "00");
    }
    const std::string_view command = request.command;
    if (command == "TM" || command == kScipIdentity || command == kScipLimits || command == kScipState ||
        command == kScipReset || command == kScipResetShort)
        return replyTo(request, now);
    return laserReply(request.line, isNew ? "10" : "0E");
}

std::string EmulatedLaser::replyTo(const Request& request, Time now)
{
    const std::string_view command = request.command;
    if (command == kScipIdentity)
        return identity(request.line);
    if (command == kScipLimits)
        return facts(request.line);
    if (command == kScipState)
        return condition(request.line, now);
    if (command == kScipLaserOn)
        return laserReply(request.line, isFaulty() ? "01" : std::exchange(isOn_, true) ? "02" : "00");
    if (command == kScipQuit) {
        stream_.reset();
        stuckStamp_.reset();
        isOn_ = false;
        return laserReply(request.line, "00");
    }
    if (command == kScipReset || command == kScipResetShort || command == kScipReboot)
        return replyToReset(request, now);
    if (command == "TM")
        return replyToTime(request, now);
    if (command == "DB")
        return replyToSimulatedFault(request);
    if (command == "SS" || command == "CR" || command == "HS")
        return replyToSetting(request);
    return replyToMeasurement(request, now);
}

std::string EmulatedLaser::replyToReset(const Request& request, Time now)
{
    if (request.command == kScipReboot) {
        if (options_.model.version() != ScipVersion::V2_2)
            return laserReply(request.line, "0E");
        const bool isSecond = rebootAsked_ && now - *rebootAsked_ <= kRebootWithin;
        rebootAsked_ = now;
        if (!isSecond)
            return laserReply(request.line, "01");
        reboot(now);
        return {};
    }
    stream_.reset();
    stuckStamp_.reset();
    isOn_ = false;
    isInTimeMode_ = false;
    simulatedFault_ = 0;
    verifyingLeft_ = 0;
    clockZero_ = now;
    if (request.command == kScipReset) {
        motorSpeed_ = 0;
        lineSpeed_ = 19'200;
    }
    return laserReply(request.line, "00");
}

std::string EmulatedLaser::replyToTime(const Request& request, Time now)
{
    if (request.parameters == "0") {
        if (isInTimeMode_)
            return laserReply(request.line, options_.model.version() == ScipVersion::V2_2 ? "00" : "02");
        stream_.reset();
        isOn_ = false;
        isInTimeMode_ = true;
        return laserReply(request.line, "00");
    }
    if (request.parameters == "1") {
        if (!isInTimeMode_)
            return laserReply(request.line, "04");
        const std::string time = toScip(stampAt(now), 4);
        return laserReply(request.line, "00", {time + scipSum(time)});
    }
    if (request.parameters == "2")
        return laserReply(request.line, std::exchange(isInTimeMode_, false) ? "00" : "03");
    return laserReply(request.line, "01");
}

std::string EmulatedLaser::replyToSetting(const Request& request)
{
    const bool isSensitivity = request.command == "HS";
    if (isSensitivity)
        return laserReply(request.line, request.parameters == "0" || request.parameters == "1" ? "00" : "01");
    if (!isNumber(request.parameters))
        return laserReply(request.line, "01");
    if (!options_.model.hasSerialLine)
        return laserReply(request.line, "04");
    const int value = number(request.parameters);
    if (request.command == "CR") {
        if (value > 10 && value != 99)
            return laserReply(request.line, "02");
        return laserReply(request.line, std::exchange(motorSpeed_, value) == value ? "03" : "00");
    }
    constexpr std::array kSpeeds{19'200, 38'400, 57'600, 115'200, 250'000, 500'000, 750'000};
    if (std::find(kSpeeds.begin(), kSpeeds.end(), value) == kSpeeds.end())
        return laserReply(request.line, "02");
    return laserReply(request.line, std::exchange(lineSpeed_, value) == value ? "03" : "00");
}

/// DB: 2 at once, 3 and 5 with the next scan, 4 a pause to check itself; 10 ends it.
std::string EmulatedLaser::replyToSimulatedFault(const Request& request)
{
    const int value = isNumber(request.parameters) ? number(request.parameters) : -1;
    if ((value < 1 || value > 5) && value != 10)
        return laserReply(request.line, "01");
    simulatedFault_ = value == 10 ? 0 : value;
    return laserReply(request.line, "00");
}

std::string_view EmulatedLaser::mistakeInMeasurement(const Request& request) const
{
    const std::string_view digits = request.parameters;
    const bool isStream = digits.size() > 10;
    if (!isNumber(digits.substr(0, 4)))
        return "01";
    if (!isNumber(digits.substr(4, 4)))
        return "02";
    if (!isNumber(digits.substr(8, 2)))
        return "03";
    const int first = number(digits.substr(0, 4));
    const int last = number(digits.substr(4, 4));
    if (last > limits_.lastStep || first < limits_.firstStep)
        return "04";
    if (last < first)
        return "05";
    if (isStream && !isNumber(digits.substr(10, 1)))
        return "06";
    if (isStream && !isNumber(digits.substr(11, 2)))
        return "07";
    return {};
}

std::string EmulatedLaser::replyToMeasurement(const Request& request, Time now)
{
    const bool hasManyEchoes = request.command.front() == 'N' || request.command.front() == 'H';
    if (hasManyEchoes)
        return laserReply(request.line, options_.model.version() == ScipVersion::V2_2 ? "0F" : "0E");
    if (const std::string_view mistake = mistakeInMeasurement(request); !mistake.empty())
        return laserReply(request.line, mistake);
    if (isFaulty())
        return laserReply(request.line, "70");
    const ScipMeasurement measurement = *readScipMeasurement({request.command, request.parameters, {}});
    if (measurement.isStream()) {
        beginStream(measurement, request.tag, now);
        isOn_ = true;
        return laserReply(request.line, "00");
    }
    if (!isOn_)
        return laserReply(request.line, "10");
    const Time sinceBegin = limits_.period * measurement.last / limits_.stepsPerTurn;
    const std::int64_t latest = turnFrom(now - sinceBegin + Time{1}) - 1;
    return laserScan(request.line, "00", measurement, stampAt(startOf(latest)), beams(measurement, latest),
                     options_.model);
}

void EmulatedLaser::beginStream(const ScipMeasurement& measurement, std::string_view tag, Time now)
{
    stuckStamp_.reset();
    stream_ = Stream{measurement, std::string{tag}, turnFrom(now), measurement.count};
    if (!firstTurn_)
        firstTurn_ = stream_->next;
}

std::string EmulatedLaser::identity(std::string_view echo) const
{
    const EmulatedLaserModel& model = options_.model;
    return laserReply(
        echo, "00",
        {laserField("VEND", "Hokuyo Automatic Co.,Ltd."),
         laserField("PROD", std::string{model.product} + (isOtherModel_ ? "-EW" : "")),
         laserField("FIRM", model.firmware), laserField("PROT", model.protocol), laserField("SERI", options_.serial)});
}

std::string EmulatedLaser::facts(std::string_view echo) const
{
    const EmulatedLaserModel& model = options_.model;
    const auto field = [](std::string_view key, int value) { return laserField(key, std::to_string(value)); };
    return laserReply(
        echo, "00",
        {laserField("MODL", modelName() + "(Hokuyo Automatic Co.,Ltd.)"), field("DMIN", model.nearest),
         field("DMAX", model.farthest), field("ARES", model.stepsPerTurn), field("AMIN", limits_.firstStep),
         field("AMAX", limits_.lastStep), field("AFRT", model.frontStep), field("SCAN", model.turnsPerMinute)});
}

std::string EmulatedLaser::condition(std::string_view echo, Time now) const
{
    const EmulatedLaserModel& model = options_.model;
    const std::string time = model.tellsTimeInHex ? hexadecimal(stampAt(now)) : toScip(stampAt(now), 4);
    return laserReply(
        echo, "00",
        {laserField("MODL", modelName() + "(Hokuyo Automatic Co.,Ltd.)"), laserField("LASR", isOn_ ? "ON" : "OFF"),
         laserField("SCSP", model.motor), laserField("MESM", stream_ ? "Measuring" : "CLASSIC"),
         laserField("SBPS", model.line), laserField("TIME", time),
         laserField("STAT", isFaulty() ? "Trouble!! Error No. =[00->33]" : "Sensor works well.")});
}

}  // namespace planewright
