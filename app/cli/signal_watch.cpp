// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/cli/signal_watch.h"

#include <ctime>

namespace planewright {

SignalWatch::SignalWatch()
{
    ::sigemptyset(&watched_);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
        struct sigaction present {};
        if (::sigaction(signal, nullptr, &present) != 0)
            continue;
        if (signal == SIGINT && present.sa_handler == SIG_IGN)
            ::signal(SIGINT, SIG_DFL);  // what is ignored may not even wait to be asked for
        else if (present.sa_handler == SIG_IGN)
            continue;
        ::sigaddset(&watched_, signal);
    }
    ::pthread_sigmask(SIG_BLOCK, &watched_, &before_);
}

SignalWatch::~SignalWatch()
{
    // One that came too late to be asked for must not end the program when its work is done.
    while (wait(std::chrono::milliseconds{0})) {
    }
    ::pthread_sigmask(SIG_SETMASK, &before_, nullptr);
}

std::optional<int> SignalWatch::wait(std::chrono::milliseconds time) const
{
    const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(time);
    const timespec span{static_cast<time_t>(seconds.count()),
                        static_cast<long>(std::chrono::nanoseconds{time - seconds}.count())};
    const int signal = ::sigtimedwait(&watched_, nullptr, &span);
    return signal > 0 ? std::optional{signal} : std::nullopt;
}

}  // namespace planewright
