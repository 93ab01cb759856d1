// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <chrono>
#include <cstdint>
#include <optional>

namespace planewright {

/// Milliseconds after which the laser's clock begins again at 0: 24 bits, 4.66 hours.
inline constexpr std::int64_t kScipClockRange = std::int64_t{1} << 24;

/// A stamp of 24 bits as a time that goes on.
struct ScipTime {
    std::int64_t milliseconds = 0;  ///< since the clock's zero of this epoch; never goes back in one
    int epoch = 0;                  ///< counts how often the clock was set anew
    bool isNewEpoch = false;        ///< this stamp is the first of its epoch, and there was one before
    int repeats = 0;                ///< how many stamps before it were the same
};

/// Follows the clock of a laser beyond its 24 bits.
///
/// A stamp that is less than the one before by more than half of the range has passed its end; one that is less by less
/// comes from a clock that was set to zero, and opens an epoch. So does one that has gone on by more than the time that
/// passed here: a clock that was set to zero late in its range looks like one that has passed the end. Where a stamp is
/// known to have come promptly, one that has gone on by less than that opens an epoch too.
class ScipStamps {
public:
    ScipTime take(std::uint32_t stamp, std::chrono::nanoseconds arrived, bool isPrompt = false);

    /// The next stamp opens an epoch silently: nothing is known of the time between.
    void forget();

private:
    ScipTime last_;
    std::uint32_t stamp_ = 0;
    std::chrono::nanoseconds arrived_{0};
    bool hasLast_ = false;
};

}  // namespace planewright
