// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>

#include "devices/dynamixel/requests.h"
#include "devices/emulated/emulated_servo.h"

namespace planewright {

namespace {

using namespace std::chrono_literals;

constexpr int kBitsOfByte = 10;
constexpr std::uint64_t kBytesOfOneLost = 1000;

}  // namespace

void EmulatedServo::handle(const DynamixelPacket& request, Time now)
{
    if (request.code == static_cast<std::uint8_t>(DynamixelInstruction::SyncWrite))
        return handleSyncWrite(request, now);
    if (request.code == static_cast<std::uint8_t>(DynamixelInstruction::SyncRead))
        return handleSyncRead(request, now);
    std::vector<DynamixelStatus> inTurn;
    std::vector<std::pair<DynamixelStatus, Time>> atOnce;
    for (ServoBody& body : bodies_) {
        if (request.id != body.id() && request.id != kBroadcastId)
            continue;
        const Time delay = body.returnDelay();
        const std::optional<DynamixelStatus> status = body.handle(request, now);
        if (!status)
            continue;
        // In 1.0 nobody answers what is said to all; in 2.0 they answer a ping in the order of their numbers.
        if (request.id != kBroadcastId)
            atOnce.emplace_back(*status, delay);
        else if (kind_.protocol == DynamixelProtocol::Two)
            inTurn.push_back(*status);
    }
    std::stable_sort(inTurn.begin(), inTurn.end(), [](const auto& a, const auto& b) { return a.id < b.id; });
    answerInTurn(inTurn, now);
    answerAtOnce(atOnce, now);
}

void EmulatedServo::handleSyncWrite(const DynamixelPacket& request, Time now)
{
    const std::size_t width = kind_.protocol == DynamixelProtocol::One ? 1 : 2;
    const std::span<const std::uint8_t> parameters{request.parameters};
    if (request.id != kBroadcastId || parameters.size() < 2 * width)
        return;
    const auto address = static_cast<std::uint16_t>(fromLittleEndian(parameters.first(width)));
    const std::size_t count = fromLittleEndian(parameters.subspan(width, width));
    std::span<const std::uint8_t> rest = parameters.subspan(2 * width);
    if (count == 0 || rest.size() % (count + 1) != 0)
        return;
    for (; !rest.empty(); rest = rest.subspan(count + 1)) {
        for (ServoBody& body : bodies_) {
            if (body.id() == rest[0])
                body.writeFor(address, rest.subspan(1, count), now);
        }
    }
}

void EmulatedServo::handleSyncRead(const DynamixelPacket& request, Time now)
{
    const std::span<const std::uint8_t> parameters{request.parameters};
    if (kind_.protocol != DynamixelProtocol::Two || request.id != kBroadcastId || parameters.size() < 4)
        return;
    const auto address = static_cast<std::uint16_t>(fromLittleEndian(parameters.first(2)));
    const auto count = static_cast<std::uint16_t>(fromLittleEndian(parameters.subspan(2, 2)));
    std::vector<DynamixelStatus> statuses;
    for (const std::uint8_t id : parameters.subspan(4)) {
        for (ServoBody& body : bodies_) {
            if (body.id() != id)
                continue;
            if (const std::optional<DynamixelStatus> status = body.readFor(address, count, now))
                statuses.push_back(*status);
        }
    }
    answerInTurn(statuses, now);
}

void EmulatedServo::answerInTurn(const std::vector<DynamixelStatus>& statuses, Time now)
{
    Time from = now;
    for (const DynamixelStatus& status : statuses) {
        const Speech said = speech(status, from + bodies_.front().returnDelay());
        from = said.from + timeOf(said.bytes.size());
        say(said);
    }
}

/// Those who speak at the same time spoil each other's bytes.
void EmulatedServo::answerAtOnce(const std::vector<std::pair<DynamixelStatus, Time>>& statuses, Time now)
{
    std::optional<Speech> line;
    for (const auto& [status, delay] : statuses) {
        const Speech said = speech(status, now + delay);
        if (!line || said.from >= line->from + timeOf(line->bytes.size())) {
            if (line)
                say(*line);
            line = said;
            continue;
        }
        const auto shift = static_cast<std::size_t>((said.from - line->from) / timeOf(1));
        line->bytes.resize(std::max(line->bytes.size(), shift + said.bytes.size()), 0xFF);
        for (std::size_t i = 0; i < said.bytes.size(); ++i)
            line->bytes[shift + i] &= said.bytes[i];
    }
    if (line)
        say(*line);
}

/// What it says is wrong with requests: a bit of the error byte in 1.0, a number in 2.0.
std::uint8_t EmulatedServo::refusalBits() const
{
    const bool isOne = kind_.protocol == DynamixelProtocol::One;
    if (has(ServoFault::AngleBit))
        return isOne ? 0x02 : 0x06;
    if (has(ServoFault::RangeBit))
        return isOne ? 0x08 : 0x04;
    if (has(ServoFault::ChecksumBit))
        return isOne ? 0x10 : 0x03;
    if (has(ServoFault::InstructionBit))
        return isOne ? 0x40 : 0x02;
    return 0;
}

EmulatedServo::Speech EmulatedServo::speech(DynamixelStatus status, Time from)
{
    status.error = static_cast<std::uint8_t>(status.error | refusalBits());
    if (has(ServoFault::WrongId))
        status.id = static_cast<std::uint8_t>(status.id ^ 0x06);
    Speech said{from, encodePacket(kind_.protocol, packetOf(kind_.protocol, status))};
    if (has(ServoFault::Slow))
        said.from += 20ms + Time{static_cast<std::int64_t>(random(10'000'000))};
    if (has(ServoFault::Garbled)) {
        const std::uint64_t bit = random(8 * said.bytes.size());
        said.bytes[bit / 8] = static_cast<std::uint8_t>(said.bytes[bit / 8] ^ (1U << bit % 8));
    }
    return said;
}

void EmulatedServo::say(const Speech& speech)
{
    if (!has(ServoFault::Silent))
        transmit(speech);
}

void EmulatedServo::transmit(const Speech& speech)
{
    EmulatedOutput output{speech.from + timeOf(speech.bytes.size()), withLosses(speech.bytes)};
    const auto behind = std::upper_bound(outputs_.begin(), outputs_.end(), output.at,
                                         [](Time at, const EmulatedOutput& other) { return at < other.at; });
    outputs_.insert(behind, std::move(output));
}

EmulatedServo::Bytes EmulatedServo::withLosses(std::span<const std::uint8_t> bytes)
{
    Bytes left{bytes.begin(), bytes.end()};
    if (has(ServoFault::ByteLoss))
        std::erase_if(left, [&](std::uint8_t) { return random(kBytesOfOneLost) == 0; });
    return left;
}

EmulatedServo::Time EmulatedServo::timeOf(std::size_t bytes) const
{
    return Time{static_cast<std::int64_t>(bytes) * kBitsOfByte * 1'000'000'000 / settings_.baud};
}

}  // namespace planewright
