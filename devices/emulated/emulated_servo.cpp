// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/emulated/emulated_servo.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "core/types/angle.h"

namespace planewright {

namespace {

using namespace std::chrono_literals;

constexpr double kAngleError = degrees(12.0);
constexpr double kSecondServo = degrees(30.0);  // the second of the same number stands elsewhere
constexpr int kLowSupply = 58;
constexpr std::chrono::nanoseconds kPowerLoss = 1s;

}  // namespace

Result<std::shared_ptr<EmulatedServo>> EmulatedServo::make(const EmulatedServoSettings& settings,
                                                           std::span<const FaultAt> faults,
                                                           std::function<int(std::chrono::nanoseconds)> turns)
{
    Result<std::vector<ServoFaultAt>> read = readServoFaults(faults);
    if (!read)
        return tl::unexpected(read.error());
    const EmulatedServoKind* kind = findEmulatedServoKind(settings.model);
    if (kind == nullptr)
        return fail(ErrorCode::Usage, "servo model " + std::to_string(settings.model) +
                                          " cannot be emulated; known are " + knownEmulatedServoKinds());
    const std::set<std::uint8_t> ids{settings.ids.begin(), settings.ids.end()};
    if (ids.empty() || ids.size() != settings.ids.size() || *ids.rbegin() > 252 || settings.baud <= 0)
        return fail(ErrorCode::Usage, "emulated servos need numbers from 0 to 252, each once, and a rate");
    std::shared_ptr<EmulatedServo> servo{new EmulatedServo{*kind, settings, std::move(*read), std::move(turns)}};
    const double count = kind->middle + servo->shaftOf(settings.pitch) / kind->countAngle;
    if (!(count >= 0.0 && count <= kind->highestCount))
        return fail(ErrorCode::Usage, "the emulated servo cannot stand at this pitch");
    return servo;
}

EmulatedServo::EmulatedServo(const EmulatedServoKind& kind, EmulatedServoSettings settings,
                             std::vector<ServoFaultAt> faults, std::function<int(std::chrono::nanoseconds)> turns)
    : kind_(kind),
      settings_(std::move(settings)),
      turns_(std::move(turns)),
      waiting_(std::move(faults)),
      random_(settings_.seed),
      parser_(kind.protocol)
{
    const double shaft = shaftOf(settings_.pitch);
    for (std::size_t i = 0; i < settings_.ids.size(); ++i) {
        bodies_.emplace_back(kind_, settings_.ids[i], i == 0 ? shaft : 0.0, settings_.dynamics);
        for (const auto& [address, value] : settings_.registers)
            bodies_.back().memory().preset(address, value);
    }
    bringFaults(now_);
}

double EmulatedServo::shaftOf(double pitch) const
{
    const TiltMounting& mounting = settings_.mounting;
    return (pitch - mounting.zeroPitch) / (mounting.sign * mounting.scale);
}

double EmulatedServo::pitchAt(Time at)
{
    if (at >= now_)
        advance(at);
    const TiltMounting& mounting = settings_.mounting;
    return mounting.zeroPitch + mounting.sign * mounting.scale * bodies_.front().shaft(at);
}

void EmulatedServo::receive(std::span<const std::uint8_t> bytes, Time now)
{
    advance(now);
    lineFree_ = std::max(lineFree_, now_) + timeOf(bytes.size());
    coming_.push_back({lineFree_, withLosses(bytes)});
}

std::vector<EmulatedOutput> EmulatedServo::takeOutput(Time now)
{
    advance(now);
    std::vector<EmulatedOutput> taken;
    while (!outputs_.empty() && outputs_.front().at <= now) {
        taken.push_back(std::move(outputs_.front()));
        outputs_.pop_front();
    }
    return taken;
}

std::optional<std::chrono::nanoseconds> EmulatedServo::nextOutput() const
{
    std::optional<Time> next;
    for (const std::deque<EmulatedOutput>* queue : {&coming_, &outputs_}) {
        if (!queue->empty() && (!next || queue->front().at < *next))
            next = queue->front().at;
    }
    return next;
}

bool EmulatedServo::isConnected(Time now)
{
    advance(now);
    return isConnected_;
}

/// Obeys what has come up to a moment, each request at its own.
void EmulatedServo::advance(Time now)
{
    while (!coming_.empty() && coming_.front().at <= now) {
        const EmulatedOutput arrival = std::move(coming_.front());
        coming_.pop_front();
        now_ = std::max(now_, arrival.at);
        bringFaults(now_);
        if (!isConnected_)
            continue;
        if (has(ServoFault::Echo))
            transmit({arrival.at - timeOf(arrival.bytes.size()), arrival.bytes});
        for (const DynamixelPacket& request : parser_.push(arrival.bytes))
            handle(request, now_);
    }
    now_ = std::max(now_, now);
    bringFaults(now_);
}

void EmulatedServo::bringFaults(Time now)
{
    const int turn = turns_ ? turns_(now) : 0;
    std::vector<ServoFaultAt> due;
    std::erase_if(waiting_, [&](const ServoFaultAt& fault) {
        const bool isDue = fault.step <= turn;
        if (isDue)
            due.push_back(fault);
        return isDue;
    });
    for (const ServoFaultAt& fault : due)
        bring(fault.fault, now);
}

void EmulatedServo::bring(ServoFault fault, Time now)
{
    if (!active_.emplace(fault, now).second)
        return;
    ServoBody& body = bodies_.front();
    const double shaft = body.shaft(now);
    switch (fault) {
        case ServoFault::Stall:
            body.stall(now);
            break;
        case ServoFault::Frozen:
            body.freeze(now);
            break;
        case ServoFault::Overload:
            body.overload(now);
            break;
        case ServoFault::Overheat:
            body.overheat(now);
            break;
        case ServoFault::Voltage:
            body.setSupply(kLowSupply, now);
            break;
        case ServoFault::Wheel:
            body.becomeWheel();
            break;
        case ServoFault::PowerLoss: {
            const double sunk = shaft - degrees(15.0 + static_cast<double>(random(10)));
            body.losePower(now, now + kPowerLoss, std::max(sunk, -kind_.middle * kind_.countAngle));
            break;
        }
        case ServoFault::WrongAngle:
            body.tellWrongAngles(random(2) == 0 ? kAngleError : -kAngleError);
            break;
        case ServoFault::Two:
            bodies_.emplace_back(kind_, body.id(), shaft > 0.0 ? shaft - kSecondServo : shaft + kSecondServo,
                                 settings_.dynamics);
            break;
        case ServoFault::Unplug:
            isConnected_ = false;
            break;
        case ServoFault::Silent:
        case ServoFault::Garbled:
        case ServoFault::WrongId:
        case ServoFault::Echo:
        case ServoFault::Slow:
        case ServoFault::ByteLoss:
        case ServoFault::AngleBit:
        case ServoFault::RangeBit:
        case ServoFault::ChecksumBit:
        case ServoFault::InstructionBit:
            break;  // of the line, wherever bytes pass
    }
}

}  // namespace planewright
