// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "devices/board/board_frame.h"

namespace planewright::board {

/// Cuts a stream of bytes into frames. What is damaged is counted and left out; after it the next 0x00 begins anew, so
/// garbage costs one frame. Keeps at most one frame's bytes.
class FrameParser {
public:
    /// What has come since it was made.
    struct Counters {
        std::uint64_t frames = 0;     ///< undamaged, those that were repeated not counted
        std::uint64_t cobs = 0;       ///< not stuffed as they must be
        std::uint64_t length = 0;     ///< too long, or not as long as they say
        std::uint64_t crc = 0;        ///< wrong checksum
        std::uint64_t version = 0;    ///< of another version of the protocol
        std::uint64_t lostBytes = 0;  ///< of all that was thrown away for these
        std::uint64_t lostEvents = 0;
        std::uint64_t repeatedEvents = 0;

        std::uint64_t damaged() const { return cobs + length + crc + version; }
    };

    /// The frames that these bytes complete, in order. An event that comes twice in a row is given once.
    std::vector<Frame> push(std::span<const std::uint8_t> bytes);

    const Counters& counters() const { return counters_; }

    /// A frame that was thrown away.
    struct Damaged {
        Damage damage;
        std::vector<std::uint8_t> bytes;  ///< of one that was too long only the beginning
    };
    /// Those of the last push(), kMostDamaged at most.
    const std::vector<Damaged>& damaged() const { return damaged_; }
    static constexpr std::size_t kMostDamaged = 20;

private:
    void endFrame(std::vector<Frame>& frames);
    void throwAway(Damage damage, std::vector<std::uint8_t> bytes);
    /// False for an event that has been there.
    bool countEvent(const Frame& frame);

    Counters counters_;
    std::vector<Damaged> damaged_;
    std::vector<std::uint8_t> pending_;
    bool isTooLong_ = false;
    std::optional<std::uint16_t> nextEvent_;
};

}  // namespace planewright::board
