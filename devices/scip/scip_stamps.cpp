// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/scip/scip_stamps.h"

namespace planewright {

namespace {

using std::chrono::milliseconds;

/// By which time may seem to differ between two stamps, since the way of the first was long.
constexpr std::int64_t kSlack = 5'000;
/// The same where neither way is long.
constexpr std::int64_t kPromptSlack = 500;

}  // namespace

ScipTime ScipStamps::take(std::uint32_t stamp, std::chrono::nanoseconds arrived, bool isPrompt)
{
    if (!hasLast_) {
        last_ = {stamp, last_.epoch + 1, false, 0};
    } else if (stamp == stamp_) {
        last_.isNewEpoch = false;
        ++last_.repeats;
    } else {
        std::int64_t advance = static_cast<std::int64_t>(stamp) - static_cast<std::int64_t>(stamp_);
        if (advance < -kScipClockRange / 2)
            advance += kScipClockRange;
        const std::int64_t passed = std::chrono::duration_cast<milliseconds>(arrived - arrived_).count();
        const std::int64_t drift = passed / 100;
        const bool isNew =
            advance < 0 || advance > passed + drift + kSlack || (isPrompt && advance < passed - drift - kPromptSlack);
        if (isNew)
            last_ = {stamp, last_.epoch + 1, true, 0};
        else
            last_ = {last_.milliseconds + advance, last_.epoch, false, 0};
    }
    stamp_ = stamp;
    arrived_ = arrived;
    hasLast_ = true;
    return last_;
}

void ScipStamps::forget()
{
    hasLast_ = false;
}

}  // namespace planewright
