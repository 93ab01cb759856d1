// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/board/board_speech.h"

#include <optional>
#include <string>

#include "devices/board/board_frame.h"
#include "devices/board/board_requests.h"

namespace planewright {

using namespace board;

namespace {

/// The frame that was written at once, with or without a 0x00 before it.
std::optional<Frame> frameOf(std::span<const std::uint8_t> message)
{
    while (!message.empty() && message.front() == 0)
        message = message.subspan(1);
    if (message.empty() || message.back() != 0)
        return std::nullopt;
    const tl::expected<Frame, Damage> frame = decodeFrame(message.first(message.size() - 1));
    return frame ? std::optional{*frame} : std::nullopt;
}

}  // namespace

DialogueSpeech::Meaning BoardSpeech::meaningOf(std::span<const std::uint8_t> message) const
{
    const std::optional<Frame> frame = frameOf(message);
    if (!frame)
        return {std::string{message.begin(), message.end()}, false};
    const bool isHeartbeat = frame->type == Heartbeat::kType;
    std::string what{"NTB/1 "};
    what += static_cast<char>(frame->type);
    if (!isHeartbeat)
        what.append(frame->payload.begin(), frame->payload.end());
    return {what, isHeartbeat || frame->type == GetStatus::kType || frame->type == GetConfig::kType};
}

void BoardSpeech::pair(std::span<const std::uint8_t> then, std::span<const std::uint8_t> now)
{
    const std::optional<Frame> was = frameOf(then);
    const std::optional<Frame> is = frameOf(now);
    if (was && is)
        now_[was->seq] = is->seq;
}

DialogueSpeech::Bytes BoardSpeech::translated(Bytes bytes)
{
    Bytes all;
    for (const std::uint8_t byte : bytes) {
        pending_.push_back(byte);
        if (byte != 0)
            continue;
        const tl::expected<Frame, Damage> frame = decodeFrame(std::span{pending_}.first(pending_.size() - 1));
        if (!frame || frame->isEvent()) {
            all.insert(all.end(), pending_.begin(), pending_.end());
        } else if (const auto now = now_.find(frame->seq); now != now_.end()) {
            const Bytes renumbered = encodeFrame({now->second, frame->type, frame->payload});
            all.insert(all.end(), renumbered.begin(), renumbered.end());
        }
        pending_.clear();
    }
    return all;
}

}  // namespace planewright
