// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <map>
#include <stop_token>
#include <string>
#include <vector>

#include "app/sources/device_access.h"

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
    std::string cure;     ///< the shell command that cures the problem; empty where none does
    std::string port;     ///< of USB: where it is plugged in
    std::string serial;   ///< of a laser that was asked: its number
};

/// What a search has found.
struct FoundDevices {
    std::vector<FoundDevice> devices;
    std::string usbProblem;  ///< empty, or why nothing could be found at USB
};

/// Numbers of lasers that were asked once, by the USB port where they were then.
using KnownLasers = std::map<std::string, std::string>;

/// "laser", "servo adapter", "control board", "serial port".
std::string nameOf(FoundDevice::Kind kind);

/// What is connected by USB and at serial ports. Lasers are opened and asked who they are, which takes a second each;
/// without `asks` nothing is opened for longer than a look, and a laser is taken for the one that was known at its
/// port: opening it shows whether it is.
FoundDevices findDevices(DeviceAccess& access, bool asks, const KnownLasers& known, const std::stop_token& stop);

/// `known` with the lasers that were asked in this search.
KnownLasers withAsked(KnownLasers known, const FoundDevices& found);

}  // namespace planewright
