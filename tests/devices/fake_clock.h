// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <atomic>
#include <chrono>

#include "devices/clock.h"

namespace planewright {

/// A clock that a test sets. Where it jumps, whoever waits for a moment makes it that moment; where it stands, only the
/// test moves it on.
class FakeClock : public Clock {
public:
    enum class Kind { Jumps, Stands };
    explicit FakeClock(Kind kind = Kind::Jumps) : kind_(kind) {}

    std::chrono::nanoseconds now() const override { return now_.load(); }

    void wait(std::unique_lock<std::mutex>& lock, std::condition_variable_any& woken, const std::stop_token& stop,
              std::optional<std::chrono::nanoseconds> until) const override
    {
        if (until && kind_ == Kind::Jumps) {
            if (*until > now())
                now_ = *until;
            return;
        }
        ++waits_;
        if (!stop.stop_requested())
            woken.wait_for(lock, std::chrono::milliseconds{1});  // nobody tells of a clock that was moved on
    }

    void advance(std::chrono::nanoseconds time) { now_ = now() + time; }

    /// How often somebody has waited without jumping: a test can see that a thread has come to wait.
    int waits() const { return waits_; }

private:
    Kind kind_;
    mutable std::atomic<std::chrono::nanoseconds> now_{std::chrono::nanoseconds{0}};
    mutable std::atomic<int> waits_{0};
};

}  // namespace planewright
