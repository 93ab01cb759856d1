// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <chrono>
#include <optional>
#include <poll.h>
#include <vector>

#include "devices/transport/descriptor.h"

namespace planewright {

/// Wakes threads that wait in poll(2): once raised, it stays raised.
class WakeEvent {
public:
    /// Without one where the system has no descriptors left: isOpen() tells.
    WakeEvent();

    bool isOpen() const { return event_.isOpen(); }

    /// Any thread.
    void raise() const;

    /// To be polled for POLLIN.
    int number() const { return event_.number(); }

private:
    Descriptor event_;
};

/// How a wait on a descriptor ended.
struct Readiness {
    short events = 0;    ///< what poll(2) tells of the descriptor; 0: the time is over, or it was woken
    bool woken = false;  ///< the wake event is raised
};

/// Waits until a descriptor is ready for `events` of poll(2), the event is raised, or the time is over; without a time
/// for the others only. A signal does not end it.
Readiness waitUntilReady(int descriptor, short events, const WakeEvent& wake,
                         std::optional<std::chrono::nanoseconds> atMost);

/// The same for any number of descriptors; what poll(2) tells of each is left in its place.
void waitUntilAnyReady(std::vector<pollfd>& watched, const WakeEvent& wake,
                       std::optional<std::chrono::nanoseconds> atMost);

}  // namespace planewright
