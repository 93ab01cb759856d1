// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/emulated/emulated_board_line.h"

#include <algorithm>
#include <utility>

namespace planewright {

namespace {

constexpr std::chrono::milliseconds kDelay{80};
constexpr int kDamagedEvery = 5;
constexpr int kLostEvery = 10;
constexpr std::uint64_t kLongestGarbage = 40;

}  // namespace

void EmulatedBoardLine::send(std::vector<std::uint8_t> bytes, bool isEvent, Time at)
{
    if (isEvent && ++events_ % kLostEvery == 0 && has(BoardFault::LostEvent))
        return;
    if (has(BoardFault::Silent))
        return;
    const bool isHit = ++frames_ % kDamagedEvery == 0;
    if (isHit)
        bytes = damaged(std::move(bytes));
    if (has(BoardFault::Duplicate)) {
        const std::vector<std::uint8_t> once = bytes;
        bytes.insert(bytes.end(), once.begin(), once.end());
    }
    if (isHit && has(BoardFault::Garbage)) {
        const std::vector<std::uint8_t> before = garbage();
        bytes.insert(bytes.begin(), before.begin(), before.end());
    }
    last_ = std::max(last_, at + (has(BoardFault::Delay) ? kDelay : Time{0}));
    sent_.push_back({last_, std::move(bytes)});
}

std::vector<EmulatedOutput> EmulatedBoardLine::take(Time now)
{
    std::vector<EmulatedOutput> out;
    for (; !sent_.empty() && sent_.front().at <= now; sent_.pop_front())
        out.push_back(std::move(sent_.front()));
    return out;
}

std::optional<EmulatedBoardLine::Time> EmulatedBoardLine::next() const
{
    return sent_.empty() ? std::nullopt : std::optional{sent_.front().at};
}

std::vector<std::uint8_t> EmulatedBoardLine::damaged(std::vector<std::uint8_t> bytes)
{
    const std::size_t at = random_() % (bytes.size() - 1);  // the 0x00 stays: it costs this frame and no other
    if (has(BoardFault::Crc))
        bytes[at] ^= static_cast<std::uint8_t>(1U << (random_() % 8));
    if (has(BoardFault::ByteLoss))
        bytes.erase(bytes.begin() + static_cast<std::ptrdiff_t>(at));
    return bytes;
}

std::vector<std::uint8_t> EmulatedBoardLine::garbage()
{
    std::vector<std::uint8_t> bytes(1 + random_() % kLongestGarbage);
    for (std::uint8_t& byte : bytes)
        byte = static_cast<std::uint8_t>(random_() & 0xFF);
    // Two of three end, and the frame after them is whole.
    if (random_() % 3 != 0)
        bytes.push_back(0);
    return bytes;
}

}  // namespace planewright
