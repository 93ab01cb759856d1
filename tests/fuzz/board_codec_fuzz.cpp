// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <utility>
#include <vector>

#include "devices/board/board_message.h"
#include "devices/board/cobs.h"
#include "devices/board/frame_parser.h"

/// Bytes from a control board, cut in two ways: the first byte says how long the pieces of the second way are.

namespace {

using namespace planewright::board;

void demand(bool isTrue)
{
    if (!isTrue)
        std::abort();
}

std::vector<Frame> framesOf(std::span<const std::uint8_t> bytes, std::size_t piece, FrameParser& parser)
{
    std::vector<Frame> frames;
    while (!bytes.empty()) {
        const std::size_t count = std::min(piece, bytes.size());
        for (Frame& frame : parser.push(bytes.first(count)))
            frames.push_back(std::move(frame));
        bytes = bytes.subspan(count);
    }
    return frames;
}

void checkFrame(const Frame& frame)
{
    demand(frame.payload.size() <= kMaxPayload);
    const std::vector<std::uint8_t> wire = encodeFrame(frame);
    demand(wire.size() <= kMaxFrame + 1);
    const auto again = decodeFrame({wire.data(), wire.size() - 1});
    demand(again && *again == frame);
    demand(!toText(frame).empty());
    if (const auto message = toMessage(frame))
        demand(toFrame(frame.seq, *message) == frame);
    else
        demand(payloadLength(frame.type) != frame.payload.size());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    if (size == 0)
        return 0;
    const std::span<const std::uint8_t> bytes{data + 1, size - 1};
    FrameParser whole;
    FrameParser pieces;
    const std::vector<Frame> frames = framesOf(bytes, bytes.size() + 1, whole);
    demand(frames == framesOf(bytes, data[0] % 100U + 1, pieces));
    demand(whole.counters().damaged() == pieces.counters().damaged());
    demand(whole.counters().lostBytes == pieces.counters().lostBytes);
    demand(whole.counters().lostBytes <= bytes.size());
    demand(whole.counters().frames == frames.size());
    for (const Frame& frame : frames)
        checkFrame(frame);

    // What decodes as a frame is what encoding it gives: there is one way to write it.
    if (const auto frame = decodeFrame(bytes)) {
        std::vector<std::uint8_t> wire = encodeFrame(*frame);
        wire.pop_back();
        demand(std::vector<std::uint8_t>(bytes.begin(), bytes.end()) == wire);
    }
    const std::vector<std::uint8_t> stuffed = encodeCobs(bytes);
    const auto plain = decodeCobs(stuffed);
    demand(plain && *plain == std::vector<std::uint8_t>(bytes.begin(), bytes.end()));
    return 0;
}
