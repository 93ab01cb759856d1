// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "core/types/angle.h"
#include "core/types/error.h"

namespace planewright {

/// Where a laser or a tilt unit is connected, before anything is opened.
struct DeviceAddress {
    enum class Unit {
        Laser,      ///< a laser scanner that speaks SCIP: no word in front
        Dynamixel,  ///< dynamixel: a servo
        Board,      ///< board: a control board
    };
    enum class Link {
        Usb,       ///< usb:SERIAL, usb:@PORT, or usb: where there is just one
        Tcp,       ///< tcp:HOST:PORT, a host with colons in brackets
        Serial,    ///< serial:PATH
        Dialogue,  ///< dialogue:FILE, a session that was recorded
    };
    Unit unit = Unit::Laser;
    Link link = Link::Usb;
    std::string name;        ///< serial number, host, path of the port, or path of the file
    std::uint16_t port = 0;  ///< of Tcp
    std::string usbPort;     ///< of Usb, behind an '@': where it is plugged in, "1-4.2"; empty: anywhere

    int baud = 115200;     ///< baud= [bit/s]; a servo's is 57142 where nobody says otherwise
    int id = 1;            ///< id= of a servo on its bus
    bool hasEcho = false;  ///< echo=yes: a servo's adapter is known to send back what is sent to it
    bool isInTime = true;  ///< speed=1 of a dialogue: at the pace at which it was recorded; speed=0 as fast as possible

    std::optional<double> zeroPitch;  ///< zero=, given in degrees: pitch φ at the unit's middle position [rad]
    double sign = 1.0;                ///< sign=+ or sign=-: whether φ grows with the unit's counts
    double scale = 1.0;               ///< scale=: true angle over the one that the counts stand for
    std::optional<double> lowest;     ///< lowest=, given in degrees: soft limits of the pitch φ [rad]
    std::optional<double> highest;    ///< highest=, given in degrees [rad]
    std::optional<double> fastest;    ///< fastest=, given in degrees a second: speed limit [rad/s]
};

/// Soft limits of a tilt unit and its speed limit where an address does not say otherwise: from straight down over
/// level to straight up behind.
inline constexpr double kLowestPitch = degrees(0.0);
inline constexpr double kHighestPitch = degrees(180.0);
inline constexpr double kFastestTilt = degrees(120.0);  ///< [rad/s]

/// True where a text begins as the address of a laser, a servo or a board does: files are not taken for these.
bool isDeviceAddress(const std::string& text);

/// Reads an address; options begin at the last '?'.
///
/// Errors (Usage) begin with the address: no such unit or link, no name, an unknown key (with those known), a key
/// twice, a number that is none or out of limits, soft limits in which nothing lies. Whether the device is there shows
/// when it is opened.
Result<DeviceAddress> parseDeviceAddress(const std::string& text);

}  // namespace planewright
