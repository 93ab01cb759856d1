// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <stop_token>

namespace planewright {

/// Time, and waiting for it: a test brings its own, in which an hour takes no time.
class Clock {
public:
    virtual ~Clock() = default;

    /// Time since any fixed moment; it never goes back. Any thread.
    virtual std::chrono::nanoseconds now() const = 0;

    /// Waits until `woken` is notified, the moment has come, or a stop is asked for; without a moment for the others
    /// only. May come back early for no reason: callers look again at what they wait for. The lock is held before and
    /// after, and is the one under which that is changed.
    virtual void wait(std::unique_lock<std::mutex>& lock, std::condition_variable_any& woken,
                      const std::stop_token& stop, std::optional<std::chrono::nanoseconds> until) const = 0;
};

/// The machine's own clock.
const Clock& steadyClock();

}  // namespace planewright
