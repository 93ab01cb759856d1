// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <stop_token>
#include <string>
#include <vector>

#include "app/sources/device_opener.h"

namespace planewright {

/// Something that is connected, and what it may be opened as.
struct FoundDevice {
    enum class Kind {
        Laser,
        ServoAdapter,
        ControlBoard,  ///< or another modem that is no laser
        SerialPort,    ///< anything may be behind it
    };
    Kind kind = Kind::Laser;
    std::string address;  ///< as --scanner or --tilt-unit take it
    std::string name;     ///< what it says of itself
    std::string problem;  ///< empty, or why it cannot be opened and what to do
};

/// "laser", "servo adapter", "control board", "serial port".
std::string nameOf(FoundDevice::Kind kind);

/// What is connected by USB and at serial ports. Lasers are opened and asked who they are, which takes a second each;
/// without `asks` they are listed by where they are plugged in, and nothing is opened for longer than a look.
std::vector<FoundDevice> findDevices(DeviceOpener& opener, bool asks, const std::stop_token& stop);

}  // namespace planewright
