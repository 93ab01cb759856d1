// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>
#include <poll.h>
#include <stop_token>
#include <string>
#include <vector>

#include "core/types/error.h"
#include "devices/clock.h"
#include "devices/emulated/emulated_device.h"
#include "devices/emulated/served_line.h"
#include "devices/transport/wake_event.h"

namespace planewright {

/// Serves emulated devices to other processes, in real time: the devices of one rig together, on the thread of the
/// caller, so that they need no lock among them.
class DeviceServer {
public:
    /// The machine's clock, except in a test.
    explicit DeviceServer(const Clock& clock = steadyClock()) : clock_(clock) {}

    /// Serves a device, which must outlive the server, at a place as ServedLine::open() reads it; gives the address
    /// that clients open. Errors as there.
    Result<std::string> add(EmulatedDevice& device, const std::string& where);

    /// Serves until a stop. Errors (Internal): the system has no descriptor left to be stopped by.
    Result<void> run(const std::stop_token& stop);

private:
    struct Served {
        EmulatedDevice& device;
        std::unique_ptr<ServedLine> line;
    };

    /// Lets a device hear and speak; gives until when it has nothing more to say.
    std::chrono::nanoseconds serve(Served& served);
    void waitUntil(std::chrono::nanoseconds moment, const WakeEvent& stopped);

    const Clock& clock_;
    std::vector<Served> all_;
    std::vector<pollfd> watched_;
};

}  // namespace planewright
