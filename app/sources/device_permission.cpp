// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/sources/device_permission.h"

#include <algorithm>
#include <cerrno>

#include "devices/transport/serial_line.h"
#include "devices/transport/usb_error.h"

namespace planewright {

std::optional<Hindrance> hindranceOf(const UsbDevice& device)
{
    switch (device.access) {
        case UsbAccess::Openable:
            break;
        case UsbAccess::Denied:
            return Hindrance{device.name() +
                                 ": you may not use it yet; choose its serial port instead, where you may use that, or "
                                 "once, run: " +
                                 usbPermissionCommand(),
                             usbPermissionCommand()};
        case UsbAccess::Busy:
            return Hindrance{device.name() + ": " + (device.holder.empty() ? "another program" : device.holder) +
                                 " uses it; close that one",
                             {}};
    }
    return std::nullopt;
}

std::optional<Hindrance> hindranceOf(const std::string& serialPort)
{
    if (!isForbiddenPort(serialPort))
        return std::nullopt;
    return Hindrance{serialPort + ": " + serialTroubleText(EACCES, serialPort), serialPermissionCommand(serialPort)};
}

std::optional<Hindrance> hindranceOf(const DeviceAddress& address, DeviceAccess& devices)
{
    if (address.link == DeviceAddress::Link::Serial)
        return hindranceOf(address.name);
    if (address.link != DeviceAddress::Link::Usb)
        return std::nullopt;
    const auto there = devices.usbDevices();
    if (!there)
        return Hindrance{there.error().message, {}};
    const std::vector<UsbDevice> meant = usbDevicesOf(address, *there);
    // As long as one of them may be used, asking it tells whether it is the one.
    const bool areDenied = !meant.empty() && std::all_of(meant.begin(), meant.end(), [](const UsbDevice& device) {
        return device.access == UsbAccess::Denied;
    });
    return areDenied ? hindranceOf(meant.front()) : std::nullopt;
}

}  // namespace planewright
