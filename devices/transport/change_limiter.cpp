// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/transport/change_limiter.h"

#include <utility>

namespace planewright {

void ChangeLimiter::note(std::chrono::nanoseconds now)
{
    const auto before = std::exchange(last_[oldest_], now);
    oldest_ = (oldest_ + 1) % last_.size();
    const bool isStorm = before && now - *before < std::chrono::seconds{1};
    if (!due_)
        due_ = isStorm ? now + kQuiet : now;
}

bool ChangeLimiter::take(std::chrono::nanoseconds now)
{
    if (!due_ || now < *due_)
        return false;
    due_.reset();
    return true;
}

}  // namespace planewright
