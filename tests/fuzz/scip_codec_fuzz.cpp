// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "devices/scip/scip_decoder.h"
#include "devices/scip/scip_encoding.h"

using namespace planewright;

namespace {

/// Unlike assert(), also in a build that is fast.
void require(bool holds)
{
    if (!holds)
        std::abort();
}

/// A scan as it must have come: nothing is in it that was not sent.
std::string sentAs(const ScipFrame& frame)
{
    const ScipMeasurement& asked = frame.measurement;
    std::string payload;
    const auto add = [&](std::uint32_t range, std::uint32_t intensity) {
        payload += toScip(range, asked.charactersPerRange());
        if (asked.hasIntensity())
            payload += toScip(intensity, 3);
    };
    auto further = frame.furtherEchoes.begin();
    for (std::size_t value = 0; value < frame.ranges.size(); ++value) {
        add(frame.ranges[value], asked.hasIntensity() ? frame.intensities[value] : 0);
        for (; further != frame.furtherEchoes.end() && further->value == value; ++further) {
            payload += '&';
            add(further->range, further->intensity);
        }
    }
    require(further == frame.furtherEchoes.end());
    std::string stamp = toScip(frame.stamp, 4);
    stamp += scipSum(stamp);
    return frame.echo + (asked.isStream() ? "\n99b\n" : "\n00P\n") + stamp + '\n' + toScipBlock(payload);
}

void check(const ScipEvent& event, std::string_view input)
{
    if (const auto* const frame = std::get_if<ScipFrame>(&event)) {
        require(frame->ranges.size() == static_cast<std::size_t>(frame->measurement.values()));
        require(frame->intensities.size() == (frame->measurement.hasIntensity() ? frame->ranges.size() : 0));
        require(frame->furtherEchoes.size() <= 2 * frame->ranges.size());
        require(input.find(sentAs(*frame)) != std::string_view::npos);
    } else if (const auto* const reply = std::get_if<ScipReply>(&event)) {
        require(readScipEcho(reply->echo).has_value());
        require(reply->status.size() == 1 || reply->status.size() == 2);
    } else {
        const std::string& bytes = std::get<ScipDamage>(event).bytes;
        require(!bytes.empty() && bytes.size() <= ScipDecoder::kLongestFrame);
    }
}

/// An event as text, to compare.
std::string textOf(const ScipEvent& event)
{
    if (const auto* const frame = std::get_if<ScipFrame>(&event))
        return "F" + sentAs(*frame);
    if (const auto* const reply = std::get_if<ScipReply>(&event)) {
        std::string text = "R" + reply->echo + '\n' + reply->status;
        for (const ScipLine& line : reply->lines)
            text += '\n' + line.text + (line.isIntact ? '+' : '-');
        return text;
    }
    const ScipDamage& damage = std::get<ScipDamage>(event);
    return "D" + std::to_string(static_cast<int>(damage.kind)) + damage.bytes;
}

std::vector<std::string> textsOf(const std::vector<ScipEvent>& events)
{
    std::vector<std::string> texts;
    std::transform(events.begin(), events.end(), std::back_inserter(texts), textOf);
    return texts;
}

}  // namespace

/// The first byte tells in what pieces the others come; what comes out of them must not depend on that.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    if (size == 0)
        return 0;
    std::uint32_t random = data[0];
    const std::span<const std::uint8_t> bytes{data + 1, size - 1};
    const std::string_view input{reinterpret_cast<const char*>(bytes.data()), bytes.size()};

    ScipDecoder whole;
    const std::vector<ScipEvent> events = whole.push(bytes);
    for (const ScipEvent& event : events)
        check(event, input);
    const auto damages = std::count_if(
        events.begin(), events.end(), [](const ScipEvent& event) { return std::holds_alternative<ScipDamage>(event); });
    require(whole.damage().total() == static_cast<std::uint64_t>(damages));
    require(whole.waiting() <= ScipDecoder::kLongestFrame);

    ScipDecoder pieces;
    std::vector<std::string> texts;
    for (std::size_t at = 0; at < bytes.size();) {
        random = random * 1'664'525U + 1'013'904'223U;
        const std::size_t length = std::min<std::size_t>(1 + (random >> 24U) % 100, bytes.size() - at);
        for (std::string& text : textsOf(pieces.push(bytes.subspan(at, length))))
            texts.push_back(std::move(text));
        require(pieces.waiting() <= ScipDecoder::kLongestFrame);
        at += length;
    }
    require(texts == textsOf(events));
    return 0;
}
