// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <string>

#include "app/sources/device_access.h"

namespace planewright {

/// What keeps a device from being opened.
struct Hindrance {
    std::string problem;  ///< what it is, and what to do
    std::string cure;     ///< the shell command among that; empty where none helps
};

/// What keeps a USB device from being opened now, if anything does.
std::optional<Hindrance> hindranceOf(const UsbDevice& device);

/// The same of a serial port; nothing, too, where there is no such port.
std::optional<Hindrance> hindranceOf(const std::string& serialPort);

/// The same of what an address names: nothing where another link than USB or a serial port is meant, or nothing is
/// there.
std::optional<Hindrance> hindranceOf(const DeviceAddress& address, DeviceAccess& devices);

}  // namespace planewright
