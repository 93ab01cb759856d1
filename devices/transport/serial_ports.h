// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace planewright {

/// A serial port of the system, with what the device behind it says of itself.
struct SerialPort {
    std::string path;              ///< what is opened: "/dev/ttyACM0"
    std::string vendor;            ///< as text, empty where unknown
    std::string product;           ///< as text, empty where unknown
    std::string serial;            ///< of the USB device, empty where it has none
    std::uint16_t usbVendor = 0;   ///< 0: not of USB
    std::uint16_t usbProduct = 0;  ///< 0 is a number that lasers have: look at usbVendor first
};

/// The serial ports that are there now, by path.
std::vector<SerialPort> serialPorts();

}  // namespace planewright
