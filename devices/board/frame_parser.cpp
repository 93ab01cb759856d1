// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/board/frame_parser.h"

#include <utility>

#include "devices/board/board_replies.h"

namespace planewright::board {

namespace {

/// Events are numbered on a ring of this many.
constexpr unsigned kEventNumbers = 0x8000;
/// More than this many cannot have been lost: the board has begun to count anew.
constexpr unsigned kMostAhead = kEventNumbers / 2;

}  // namespace

std::vector<Frame> FrameParser::push(std::span<const std::uint8_t> bytes)
{
    std::vector<Frame> frames;
    damaged_.clear();
    for (const std::uint8_t byte : bytes) {
        if (byte == 0)
            endFrame(frames);
        else if (pending_.size() < kMaxFrame)
            pending_.push_back(byte);
        else {
            isTooLong_ = true;
            ++counters_.lostBytes;
        }
    }
    return frames;
}

void FrameParser::endFrame(std::vector<Frame>& frames)
{
    std::vector<std::uint8_t> bytes = std::exchange(pending_, {});
    if (std::exchange(isTooLong_, false))
        return throwAway(Damage::Length, std::move(bytes));
    if (bytes.empty())
        return;  // a sender may begin with a 0x00 to end what came before
    tl::expected<Frame, Damage> frame = decodeFrame(bytes);
    if (!frame)
        return throwAway(frame.error(), std::move(bytes));
    if (frame->isEvent() && !countEvent(*frame))
        return;
    if (frame->type == HelloReply::kType)
        nextEvent_ = kFirstEvent;
    ++counters_.frames;
    frames.push_back(std::move(*frame));
}

void FrameParser::throwAway(Damage damage, std::vector<std::uint8_t> bytes)
{
    counters_.lostBytes += bytes.size();
    if (damaged_.size() < kMostDamaged)
        damaged_.push_back({damage, std::move(bytes)});
    switch (damage) {
        case Damage::Cobs:
            ++counters_.cobs;
            break;
        case Damage::Length:
            ++counters_.length;
            break;
        case Damage::Crc:
            ++counters_.crc;
            break;
        case Damage::Version:
            ++counters_.version;
            break;
    }
}

bool FrameParser::countEvent(const Frame& frame)
{
    const unsigned ahead = (frame.seq - nextEvent_.value_or(frame.seq)) & (kEventNumbers - 1);
    if (ahead == kEventNumbers - 1) {
        ++counters_.repeatedEvents;
        return false;
    }
    if (ahead < kMostAhead)
        counters_.lostEvents += ahead;
    nextEvent_ = static_cast<std::uint16_t>(kFirstEvent | ((frame.seq + 1U) & (kEventNumbers - 1)));
    return true;
}

}  // namespace planewright::board
