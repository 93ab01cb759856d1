// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/clock.h"

#include <utility>

namespace planewright {

namespace {

class SteadyClock : public Clock {
public:
    std::chrono::nanoseconds now() const override { return std::chrono::steady_clock::now().time_since_epoch(); }

    void wait(std::unique_lock<std::mutex>& lock, std::condition_variable_any& woken, const std::stop_token& stop,
              std::optional<std::chrono::nanoseconds> until) const override
    {
        // The waits that a stop ends ask for a condition: here, whether anything at all has woken them.
        const auto comesBack = [asked = false]() mutable { return std::exchange(asked, true); };
        if (until)
            woken.wait_until(lock, stop, std::chrono::steady_clock::time_point{*until}, comesBack);
        else
            woken.wait(lock, stop, comesBack);
    }
};

}  // namespace

const Clock& steadyClock()
{
    static const SteadyClock clock;
    return clock;
}

}  // namespace planewright
