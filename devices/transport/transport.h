// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <span>
#include <stop_token>
#include <string>

#include "core/types/error.h"

namespace planewright {

/// What a transport knows of its own troubles, beside the errors of its calls.
struct TransportHealth {
    std::uint64_t overruns = 0;  ///< how often an adapter has told that it lost bytes, which nobody fetched in time
    std::string trouble;         ///< empty, or a line about something beside the link: its record is not complete
};

/// Bytes to one device and from it: a serial line, a USB pipe, a TCP connection, or memory.
///
/// A transport is open from when it is made until close() or until the device is gone; then every call gives the same
/// DeviceLost error. Times are those of the Clock that it was made with. One thread reads at a time and one writes;
/// both may be different ones, and any thread may close.
class Transport {
public:
    virtual ~Transport() = default;

    /// What it is to people, as messages begin with it: "/dev/ttyACM0", "192.168.0.10:10940", "usb 1-4".
    virtual std::string name() const = 0;

    /// Bytes that came together.
    struct Arrival {
        std::size_t count = 0;           ///< bytes; 0: none came before the deadline, or a stop was asked for
        std::chrono::nanoseconds at{0};  ///< when the last of them had come, by the clock
    };

    /// Waits until bytes are there and moves some of them, in order, into `into`: never bytes of two arrivals, so that
    /// `at` is true for all of them. What does not fit comes with the next call. A deadline in the past gives what is
    /// there already.
    ///
    /// Errors (DeviceLost): the device is gone or the link closed; bytes that came before are given out first.
    virtual Result<Arrival> read(std::span<std::uint8_t> into, std::chrono::nanoseconds deadline,
                                 const std::stop_token& stop) = 0;

    /// Hands over all of the bytes; returns when the system has them. Errors (DeviceLost): as for read(), and where
    /// the device has not taken them before the deadline.
    virtual Result<void> write(std::span<const std::uint8_t> bytes, std::chrono::nanoseconds deadline) = 0;

    /// Any thread.
    virtual TransportHealth health() const { return {}; }

    /// Ends it in order: no transfer is left, nothing more is sent. Whoever waits in a call comes back. Twice is fine.
    virtual void close() = 0;
};

}  // namespace planewright
