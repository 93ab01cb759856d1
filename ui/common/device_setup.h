// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

namespace planewright {

/// A scan with a laser on a tilt unit as it is set up in the window. Angles are degrees, as they are typed.
struct DeviceSetup {
    std::string laser;     ///< address: "usb:", "tcp:192.168.0.10:10940"
    std::string tiltUnit;  ///< address: "dynamixel:usb:"
    bool stepAndStare = false;
    double firstTilt = 10.0;  ///< [degrees]
    double lastTilt = 170.0;  ///< where the scan ends, no slice of its own [degrees]
    double tiltStep = 1.16;   ///< [degrees]
    double firstBearing = 0.0;
    double lastBearing = 180.0;

    friend bool operator==(const DeviceSetup&, const DeviceSetup&) = default;
};

/// Something that is connected, to be chosen.
struct DeviceChoice {
    std::string address;
    std::string name;         ///< what people call it
    std::string problem;      ///< empty, or why it cannot be used and what to do
    bool isLaser = false;     ///< may be one
    bool isTiltUnit = false;  ///< may be one
};

/// A check of the devices: what it asks, and how it went.
struct DeviceCheck {
    enum class State { Waiting, Running, Passed, Failed };
    std::string name;
    State state = State::Waiting;
    std::string detail;  ///< what was found, or what to do
};

/// What a device says of itself while it scans.
struct DeviceFact {
    std::string name;
    std::string value;
    bool isTrouble = false;
};

}  // namespace planewright
