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
    int cluster = 1;               ///< steps of the laser that are joined to one range
    double settle = 8.0;           ///< rest before a slice of Step and stare [ms]
    double travelSpeed = 90.0;     ///< between steps, and to where a scan begins [degrees/s]
    double lowest = 0.0;           ///< soft limits of the tilt [degrees]
    double highest = 180.0;        ///< [degrees]
    double fastest = 120.0;        ///< speed limit of the tilt [degrees/s]
    double axisOffset = 0.05;      ///< d_l, from the axis of the tilt to the laser's origin [m]
    std::string dialogueFolder{};  ///< where the bytes of every dialogue with the devices are kept; empty: nowhere

    friend bool operator==(const DeviceSetup&, const DeviceSetup&) = default;
};

/// The address of the tilt unit with the limits that differ from what an address means without them. What the address
/// says itself stays.
std::string tiltUnitAddress(const DeviceSetup& setup);

/// Something that is connected, to be chosen.
struct DeviceChoice {
    std::string address;
    std::string name;         ///< what people call it
    std::string problem;      ///< empty, or why it cannot be used and what to do
    bool isLaser = false;     ///< may be one
    bool isTiltUnit = false;  ///< may be one
    std::string cure{};       ///< the shell command that cures the problem; empty where none does
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
