// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <chrono>
#include <csignal>
#include <optional>

namespace planewright {

/// Takes SIGINT, SIGTERM and SIGHUP out of the way while it lives, for work that has to be ended in order: instead of
/// ending the program they wait to be asked for. To be made before the threads that are not to get them. SIGTERM and
/// SIGHUP that the caller of the program wants ignored stay so. SIGINT is always taken, though a shell has it ignored
/// by what it runs in the background: what moves, or serves others, must end when it is told to.
class SignalWatch {
public:
    SignalWatch();
    ~SignalWatch();
    SignalWatch(const SignalWatch&) = delete;
    SignalWatch& operator=(const SignalWatch&) = delete;

    /// The signal that has come, or comes within this time.
    std::optional<int> wait(std::chrono::milliseconds time) const;

private:
    sigset_t watched_;
    sigset_t before_;
};

}  // namespace planewright
