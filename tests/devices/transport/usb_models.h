// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace planewright {

/// What an emulated USB device says of itself.
struct UsbModel {
    std::vector<std::uint8_t> device;         ///< device descriptor
    std::vector<std::uint8_t> configuration;  ///< configuration descriptor with all that follows it
    std::map<int, std::string> strings;       ///< by their number: 1 manufacturer, 2 product, 3 serial
    bool stringsInSysfs = true;               ///< the kernel has read them
    std::string speed = "12";                 ///< [Mbit/s]
    std::size_t packetSize = 64;              ///< of the bulk endpoints [bytes]
    std::uint8_t in = 0x81;
    std::uint8_t out = 0x02;
    std::vector<std::string> drivers;  ///< kernel driver of each interface; empty: none
    std::string serialPort;            ///< that the kernel's driver has made of the first interface: "ttyACM0"
    bool driversInSysfs = true;        ///< the kernel shows them; takes half of the time of plugging in
    bool mayOpen = true;               ///< false: the node has mode 000
};

/// How a modem class device differs from a laser.
struct CdcVariant {
    std::uint16_t vendor = 0x15D1;
    std::uint16_t product = 0;
    std::uint8_t controlInterface = 0;
    std::uint8_t dataInterface = 1;
    std::uint8_t subclass = 2;
    std::optional<std::uint8_t> unitedWith = 1;  ///< what the union descriptor names; empty: there is none
    std::size_t packetSize = 64;
    std::uint8_t in = 0x81;
    std::uint8_t out = 0x02;
};

/// A laser, or something like it: two interfaces, the union of both, one interrupt endpoint and two bulk endpoints.
UsbModel cdcModel(const CdcVariant& variant = {});

UsbModel ft232rModel();  ///< USB2Dynamixel: full speed, packets of 64 bytes
UsbModel ft232hModel();  ///< U2D2: high speed, packets of 512 bytes

}  // namespace planewright
