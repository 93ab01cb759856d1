// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

namespace planewright {

// What Linux tells of a USB device to everybody, also to who may not open it. Other systems have no such files: then
// all of this is empty.

/// A line that the device said of itself: "manufacturer", "product", "serial". `port` is "1-4".
std::string usbAttribute(const std::string& port, const std::string& attribute);

/// The kernel driver that has an interface: "cdc_acm"; "usbfs" where a program has it.
std::string usbDriver(const std::string& port, int configuration, int interface);

/// The node of the serial port that the kernel's driver has made of an interface: "/dev/ttyACM0"; empty: none.
std::string usbSerialPort(const std::string& port, int configuration, int interface);

/// A text that a device sent, for people to read: what does not print becomes a question mark.
std::string printable(std::string text);

}  // namespace planewright
