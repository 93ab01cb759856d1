// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <chrono>
#include <cstdint>
#include <deque>
#include <optional>
#include <random>
#include <set>
#include <vector>

#include "devices/emulated/emulated_board_faults.h"
#include "devices/emulated/emulated_device.h"

namespace planewright {

/// The way from an emulated board to the host: frames in order, and what goes wrong with them there.
class EmulatedBoardLine {
public:
    using Time = std::chrono::nanoseconds;

    /// The same seed damages the same bytes.
    explicit EmulatedBoardLine(std::uint64_t seed) : random_(seed) {}

    /// Begins a fault of the line; those that are none of the line's do nothing.
    void begin(BoardFault fault) { faults_.insert(fault); }

    /// Sends a frame, its 0x00 included, that has left at a moment.
    void send(std::vector<std::uint8_t> bytes, bool isEvent, Time at);

    std::vector<EmulatedOutput> take(Time now);
    std::optional<Time> next() const;

private:
    bool has(BoardFault fault) const { return faults_.contains(fault); }
    std::vector<std::uint8_t> damaged(std::vector<std::uint8_t> bytes);
    std::vector<std::uint8_t> garbage();

    std::mt19937_64 random_;
    std::set<BoardFault> faults_;
    std::deque<EmulatedOutput> sent_;
    Time last_{0};
    std::uint64_t frames_ = 0;
    std::uint64_t events_ = 0;
};

}  // namespace planewright
