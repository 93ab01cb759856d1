// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <stop_token>

#include "core/types/error.h"
#include "devices/clock.h"

namespace planewright {

/// Slowest and fastest speed beside 0, as fast as possible.
inline constexpr double kSlowestSpeed = 0.01;
inline constexpr double kFastestSpeed = 1000.0;

/// True for 0 and for speeds from slowest to fastest.
bool isReplaySpeed(double speed);

/// Times between slices that are longer than this are shortened to it: nobody wants to see a pause again.
inline constexpr std::chrono::seconds kLongestGap{2};

/// Lets slices through at the times at which they were measured, faster, slower, or one by one.
///
/// One thread waits; any thread may steer.
class Pacer {
public:
    Pacer(const Clock& clock, double speed);

    /// Forgets the scan before: the next slice is due at once.
    void restart();

    /// Waits until the slice of this scan time is due; true where it is, false where a stop came first. Times are kept
    /// by the clock and not from one call to the next, so that what is late is made up for.
    bool wait(std::chrono::microseconds scanTime, const std::stop_token& stop);

    void pause();
    void resume();
    /// Lets one slice more through while it is paused. Errors (Usage): it is not.
    Result<void> step();
    /// Errors (Usage): no speed, with what is one.
    Result<void> setSpeed(double speed);

private:
    using Nanoseconds = std::chrono::nanoseconds;

    void accountFor(Nanoseconds now);
    Nanoseconds due() const;

    const Clock& clock_;
    std::mutex mutex_;
    std::condition_variable_any steered_;
    double speed_;
    bool paused_ = false;
    int steps_ = 0;                            ///< that are let through while it is paused
    bool begun_ = false;                       ///< a slice of this scan came through
    std::chrono::microseconds scanTime_{0};    ///< of the last one
    Nanoseconds from_{0};                      ///< clock from which on `left_` runs down
    std::chrono::duration<double> left_{0.0};  ///< scan time until the next is due
};

}  // namespace planewright
