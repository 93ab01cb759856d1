// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cmath>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

#include "devices/board/board_tilt.h"
#include "devices/emulated/emulated_link.h"
#include "tests/devices/emulated/board_host.h"
#include "tests/devices/fake_clock.h"

namespace planewright {

/// A driver, a link and an emulated board that share a clock of the test.
struct BoardRig {
    explicit BoardRig(EmulatedBoardSetup setup = levelBoard(), BoardTiltOptions options = level(),
                      FakeClock::Kind kind = FakeClock::Kind::Jumps)
        : clock(kind),
          board(EmulatedBoard::make(withTurns(std::move(setup))).value()),
          tilt(std::make_unique<EmulatedLink>(board, mutex, clock, "emulated board"), clock, options)
    {
    }

    /// Middle at 90°, 10° to 170°, at most 120° a second.
    static BoardTiltOptions level()
    {
        BoardTiltOptions options;
        options.mounting = {degrees(90.0), 1.0, 1.0, degrees(10.0), degrees(170.0), degrees(120.0)};
        return options;
    }

    /// The laser has turned once every 25 ms since the clock began, as far as faults are concerned.
    EmulatedBoardSetup withTurns(EmulatedBoardSetup setup)
    {
        setup.turns = [](std::chrono::nanoseconds at) { return static_cast<int>(at / std::chrono::milliseconds{25}); };
        return setup;
    }

    /// True φ of the motor.
    double pitchAt(std::chrono::nanoseconds at)
    {
        const std::scoped_lock lock(*mutex);
        return board->pitchAt(at);
    }
    double pitch() { return pitchAt(clock.now()); }
    board::State state()
    {
        const std::scoped_lock lock(*mutex);
        board->pitchAt(clock.now());
        return board->state();
    }

    /// Takes samples for some time; the first error ends it.
    Result<std::vector<TiltSample>> watch(std::chrono::nanoseconds time)
    {
        std::vector<TiltSample> samples;
        const std::chrono::nanoseconds end = clock.now() + time;
        while (clock.now() < end) {
            const auto sample = tilt.sample(end, {});
            if (!sample)
                return tl::unexpected(sample.error());
            if (*sample)
                samples.push_back(**sample);
        }
        return samples;
    }

    /// Takes samples until the motor is at rest, for at most 10 s: the last one. Those of before are passed over.
    Result<TiltSample> arrive()
    {
        const std::chrono::nanoseconds begun = clock.now();
        const std::chrono::nanoseconds end = begun + std::chrono::seconds{10};
        while (clock.now() < end) {
            const auto sample = tilt.sample(end, {});
            if (!sample)
                return tl::unexpected(sample.error());
            if (*sample && !(*sample)->moving && (*sample)->at > begun)
                return **sample;
        }
        return fail(ErrorCode::Internal, "it never came to rest");
    }

    FakeClock clock;
    std::shared_ptr<std::mutex> mutex = std::make_shared<std::mutex>();
    std::shared_ptr<EmulatedBoard> board;
    BoardTilt tilt;
};

/// How far a measured angle may be from the true one: half a count, and what the motor moves in the time that the
/// clocks may differ.
inline bool isTrue(BoardRig& rig, const TiltSample& sample, std::chrono::nanoseconds clocks)
{
    const double before = rig.pitchAt(sample.at - clocks);
    const double after = rig.pitchAt(sample.at + clocks);
    const double half = 0.5 * kCountAngle + 1e-9;
    return sample.pitch >= std::min(before, after) - half && sample.pitch <= std::max(before, after) + half;
}

}  // namespace planewright
