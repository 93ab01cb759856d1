// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/transport/wake_event.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <ctime>
#include <span>
#include <sys/eventfd.h>

namespace planewright {

namespace {

void waitFor(std::span<pollfd> watched, std::optional<std::chrono::nanoseconds> atMost)
{
    // Beyond what any caller means, and far from where the parts of a timespec end.
    constexpr std::chrono::nanoseconds kLongest = std::chrono::hours{24 * 365};
    const auto left = std::clamp(atMost.value_or(kLongest), std::chrono::nanoseconds{0}, kLongest);
    const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(left);
    timespec time{};
    time.tv_sec = static_cast<std::time_t>(seconds.count());
    time.tv_nsec = static_cast<long>((left - seconds).count());
    // A signal is rare, and makes the wait longer by no more than what had passed of it.
    while (::ppoll(watched.data(), watched.size(), atMost ? &time : nullptr, nullptr) < 0 && errno == EINTR)
        ;
}

}  // namespace

WakeEvent::WakeEvent() : event_(::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)) {}

void WakeEvent::raise() const
{
    const std::uint64_t one = 1;
    // Fails only where it has been raised 2^64 times already.
    [[maybe_unused]] const auto written = ::write(event_.number(), &one, sizeof one);
}

Readiness waitUntilReady(int descriptor, short events, const WakeEvent& wake,
                         std::optional<std::chrono::nanoseconds> atMost)
{
    std::array<pollfd, 2> watched{{{descriptor, events, 0}, {wake.number(), POLLIN, 0}}};
    waitFor(watched, atMost);
    return {watched[0].revents, watched[1].revents != 0};
}

void waitUntilAnyReady(std::vector<pollfd>& watched, const WakeEvent& wake,
                       std::optional<std::chrono::nanoseconds> atMost)
{
    watched.push_back({wake.number(), POLLIN, 0});
    waitFor(watched, atMost);
    watched.pop_back();
}

}  // namespace planewright
