// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <chrono>
#include <cstdint>

namespace planewright::board {

/// How many frames came in the last second, in tenths of it.
class FrameRate {
public:
    void count(std::chrono::nanoseconds at)
    {
        Slot& slot = slots_[index(at) % kSlots];
        if (slot.index != index(at))
            slot = {index(at), 0};
        ++slot.frames;
    }

    /// Frames a second, over the ten tenths before the present one.
    double at(std::chrono::nanoseconds now) const
    {
        std::uint64_t frames = 0;
        for (const Slot& slot : slots_) {
            if (slot.index < index(now) && slot.index + 10 >= index(now))
                frames += slot.frames;
        }
        return static_cast<double>(frames);
    }

private:
    static constexpr std::uint64_t kSlots = 11;
    struct Slot {
        std::uint64_t index = 0;
        std::uint64_t frames = 0;
    };
    static std::uint64_t index(std::chrono::nanoseconds at)
    {
        return static_cast<std::uint64_t>(at / std::chrono::milliseconds{100}) + kSlots;
    }

    std::array<Slot, kSlots> slots_{};
};

}  // namespace planewright::board
