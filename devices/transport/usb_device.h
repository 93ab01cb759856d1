// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <string>

namespace planewright {

/// How a USB device carries its bytes.
enum class UsbKind {
    CdcAcm,  ///< a modem class device: lasers, control boards
    Ftdi,    ///< a serial converter FT232R or FT232H: adapters of servos
};

/// Whether a device could be opened when it was looked at.
enum class UsbAccess {
    Openable,
    Denied,  ///< the user has no right to it; usbPermissionCommand() tells the cure
    Busy,    ///< another program has it, or this one
};

/// A USB device that a transport can be opened on, as UsbBus lists it.
///
/// Two devices of one kind differ in bus and address alone, and these change with every plugging in: who it is, only
/// the device itself can tell.
struct UsbDevice {
    std::uint16_t vendor = 0;
    std::uint16_t product = 0;
    std::uint8_t bus = 0;
    std::uint8_t address = 0;
    std::string port;          ///< where it is plugged in: "1-4", or "1-4.2" behind a hub
    std::string manufacturer;  ///< what it says of itself; empty: nothing, or it could not be read
    std::string productName;
    std::string serial;
    UsbKind kind = UsbKind::CdcAcm;
    UsbAccess access = UsbAccess::Openable;
    std::string driver;      ///< kernel driver that has it, "cdc_acm", and gives it up on opening; "usbfs": a program
    std::string serialPort;  ///< that this driver has made of it: "/dev/ttyACM0"
    std::string holder;      ///< who has that port open: "the program rosrun (process 4711)"; empty: nobody known

    /// What messages begin with: "usb 1-4".
    std::string name() const { return "usb " + port; }
};

}  // namespace planewright
