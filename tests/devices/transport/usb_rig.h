// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "devices/clock.h"
#include "devices/transport/transport.h"
#include "devices/transport/usb_bus.h"
#include "tests/devices/transport/emulated_usb.h"

namespace planewright {

/// An emulated machine with the product's bus on it, for one test.
struct UsbRig {
    explicit UsbRig(UsbWatch watch = UsbWatch::Hotplug);

    /// The devices, once there are so many; what there is after ten seconds otherwise.
    std::vector<UsbDevice> devices(std::size_t count) const;

    EmulatedUsb usb;
    std::atomic<int> changes{0};
    std::shared_ptr<UsbBus> bus;
};

/// Waits up to ten seconds for something to become true.
bool comesTrue(const std::function<bool()>& what);

/// Reads until so many bytes have come, the link has ended, or ten seconds are over.
std::vector<std::uint8_t> readBytes(Transport& transport, std::size_t count);

/// Reads until the link has ended, and gives why; empty where it has not after ten seconds.
std::optional<Error> readToTheEnd(Transport& transport);

/// Bytes that tell where they belong: no two places within 64 KiB look alike.
std::vector<std::uint8_t> pattern(std::size_t count, std::uint32_t seed);

/// So much time from now, by the clock of the rig.
std::chrono::nanoseconds in(std::chrono::nanoseconds time);

}  // namespace planewright
