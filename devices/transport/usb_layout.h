// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "devices/transport/usb_device.h"

struct libusb_config_descriptor;
struct libusb_device_descriptor;

namespace planewright {

inline constexpr std::uint16_t kHokuyoVendor = 0x15D1;
inline constexpr std::uint16_t kFtdiVendor = 0x0403;
inline constexpr std::uint16_t kFt232r = 0x6001;  ///< product of USB2Dynamixel, full speed
inline constexpr std::uint16_t kFt232h = 0x6014;  ///< product of U2D2, high speed

/// Where the bytes of a device go in and out.
struct UsbLayout {
    UsbKind kind = UsbKind::CdcAcm;
    std::uint8_t configuration = 0;
    std::uint8_t controlInterface = 0;
    std::uint8_t dataInterface = 0;  ///< that of an FTDI chip is its control interface too
    std::uint8_t in = 0;             ///< bulk endpoint, with the bit of its direction
    std::uint8_t out = 0;
    std::size_t packetSize = 0;  ///< of the endpoint in [bytes]: 8, 16, 32, 64, 512 or 1024
};

/// What the descriptors say; empty: no device for a transport, or descriptors that make no sense.
///
/// The data interface of a modem class device is the one that its union descriptor names, else the one after the
/// control interface. Numbers of endpoints are those of the descriptors.
std::optional<UsbLayout> usbLayout(const libusb_device_descriptor& device,
                                   const libusb_config_descriptor& configuration);

}  // namespace planewright
