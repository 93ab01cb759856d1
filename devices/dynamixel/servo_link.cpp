// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/dynamixel/servo_link.h"

#include "devices/dynamixel/requests.h"
#include "devices/dynamixel/status_error.h"

namespace planewright {

namespace {

// So many states of different lengths are asked for in turn.
constexpr int kLengths = 3;

bool isPing(const ServoQuestion& question)
{
    return question.request.code == static_cast<std::uint8_t>(DynamixelInstruction::Ping);
}

}  // namespace

ServoLink::ServoLink(Transport& transport, const Clock& clock, const Settings& settings)
    : settings_(settings), bus_(transport, clock, {settings.id, settings.baud, settings.latency})
{
}

void ServoLink::setProtocol(DynamixelProtocol protocol)
{
    const BusTurns::Turn turn(turns_, false);
    protocol_ = protocol;
    bus_.setProtocol(protocol);
}

void ServoLink::setReturnDelay(std::chrono::nanoseconds delay)
{
    const BusTurns::Turn turn(turns_, false);
    bus_.setReturnDelay(delay);
}

Result<ServoReply> ServoLink::ping(const HowToAsk& how)
{
    return ask([&] { return ServoQuestion{pingRequest(settings_.id), std::nullopt, true, true}; }, how);
}

Result<ServoReply> ServoLink::read(ServoRegion region, RegisterImage& image, const HowToAsk& how)
{
    Result<ServoReply> reply = ask(
        [&] {
            return ServoQuestion{readRequest(protocol_, settings_.id, region.first, region.count), region.count, true,
                                 false};
        },
        how);
    if (reply && reply->status.data.size() == region.count)
        image.store(region.first, reply->status.data);
    return reply;
}

Result<ServoReply> ServoLink::readState(const ControlTable& table, RegisterImage& image, const HowToAsk& how)
{
    std::uint16_t first = table.state.first;
    Result<ServoReply> reply = ask(
        [&] {
            const auto more = static_cast<std::uint16_t>(unanswered_ % kLengths);
            first = static_cast<std::uint16_t>(table.state.first - more);
            const auto count = static_cast<std::uint16_t>(table.state.count + more);
            return ServoQuestion{readRequest(protocol_, settings_.id, first, count), count, true, false};
        },
        how);
    if (reply && !reply->status.data.empty())
        image.store(first, reply->status.data);
    return reply;
}

Result<ServoReply> ServoLink::write(std::uint16_t address, std::span<const std::uint8_t> bytes, bool isAnswered,
                                    const HowToAsk& how)
{
    return ask(
        [&] {
            return ServoQuestion{writeRequest(protocol_, settings_.id, address, bytes), 0, isAnswered, false};
        },
        how);
}

Result<void> ServoLink::reboot()
{
    const Result<ServoReply> reply = ask(
        [&] {
            return ServoQuestion{rebootRequest(settings_.id), 0, true, false};
        },
        {false, 1, {}});
    if (!reply)
        return tl::unexpected(reply.error());
    return {};
}

Result<ServoReply> ServoLink::ask(const std::function<ServoQuestion()>& question, const HowToAsk& how)
{
    Result<ServoReply> reply;
    for (int i = 0; i < how.tries; ++i) {
        const BusTurns::Turn turn(turns_, how.isUrgent);
        if (how.may && !how.may())
            return fail(ErrorCode::Interrupted, subject() + " is held");
        ServoQuestion asked = question();
        asked.patience = how.patience;
        reply = bus_.ask(asked);
        if (!reply)
            return reply;
        if (reply->kind != ServoReply::Kind::Answered) {
            ++unanswered_;
            continue;
        }
        if (reply->heardEcho && !settings_.dropEcho && !isPing(asked)) {
            reply->kind = ServoReply::Kind::Echo;
            return reply;
        }
        const StatusError error = decodeStatusError(protocol_, reply->status.error);
        if (error.request == RequestFault::None)
            return reply;
        // A request that the line has damaged is asked again.
        if (error.request == RequestFault::Refused || i + 1 == how.tries) {
            const std::vector<std::uint8_t> packet = encodePacket(protocol_, asked.request);
            log().add(reply->arrived, "servo-refused", "it refused a request: " + std::string{error.refusal}, packet);
            return fail(ErrorCode::Internal, subject() + " refused a request (" + std::string{error.refusal} +
                                                 "): " + hexText(packet) + "; please report this line");
        }
    }
    return reply;
}

Result<void> ServoLink::pause(std::chrono::nanoseconds time, const std::stop_token& stop)
{
    const BusTurns::Turn turn(turns_, false);
    return bus_.pause(time, stop);
}

Error ServoLink::failure(const ServoReply& reply, ErrorCode code) const
{
    const std::string echo =
        "the adapter sends back what is sent to it. Switch its echo off (a jumper, or \"local echo\")";
    if (reply.kind == ServoReply::Kind::Echo)
        return {code, subject() + ": " + echo + ", or write echo=yes behind its address if it has no such switch"};
    if (reply.answers > 1)
        return {code, subject() +
                          ": two servos answer to this number. Connect them one at a time and give one of them "
                          "another number"};
    switch (reply.kind) {
        case ServoReply::Kind::Damaged:
            return {code, subject() +
                              ": its answers come damaged. Either two servos have this number and speak at once, "
                              "or the cable or the rate is wrong: connect one servo alone and check its plugs"};
        case ServoReply::Kind::OtherNumber:
            return {code, subject() + ": number " + std::to_string(reply.otherNumber) +
                              " answers in its place. Give each servo a number of its own, and name the right one"};
        case ServoReply::Kind::Silent:
        case ServoReply::Kind::Answered:
        case ServoReply::Kind::Echo:
            break;
    }
    if (reply.heardEcho)
        return {code, subject() + " does not answer, and " + echo + " and check the servo's power"};
    return {code, subject() + " does not answer. Check its plug and its power, then connect again"};
}

std::string ServoLink::subject() const
{
    return bus_.name() + ": servo " + std::to_string(settings_.id);
}

}  // namespace planewright
