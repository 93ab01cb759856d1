// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/sources/device_access.h"

#include <algorithm>

namespace planewright {

namespace {

constexpr std::uint16_t kHokuyo = 0x15d1;

bool isOfUnit(const UsbDevice& device, DeviceAddress::Unit unit)
{
    switch (unit) {
        case DeviceAddress::Unit::Laser:
            return isUsbLaser(device);
        case DeviceAddress::Unit::Dynamixel:
            return device.kind == UsbKind::Ftdi;
        case DeviceAddress::Unit::Board:
            break;
    }
    return device.kind == UsbKind::CdcAcm && !isUsbLaser(device);
}

}  // namespace

std::string nameOf(DeviceAddress::Unit unit)
{
    switch (unit) {
        case DeviceAddress::Unit::Laser:
            return "laser";
        case DeviceAddress::Unit::Dynamixel:
            return "servo adapter";
        case DeviceAddress::Unit::Board:
            break;
    }
    return "control board";
}

bool isUsbLaser(const UsbDevice& device)
{
    return device.kind == UsbKind::CdcAcm && device.vendor == kHokuyo;
}

std::vector<UsbDevice> usbDevicesOf(const DeviceAddress& address, std::vector<UsbDevice> devices)
{
    std::erase_if(devices, [&](const UsbDevice& device) { return !isOfUnit(device, address.unit); });
    if (address.unit == DeviceAddress::Unit::Laser) {
        // Its number is known to itself alone, and it may have been plugged in elsewhere.
        if (address.name.empty() && !address.usbPort.empty())
            std::erase_if(devices, [&](const UsbDevice& device) { return device.port != address.usbPort; });
        return devices;
    }
    if (!address.name.empty())
        std::erase_if(devices, [&](const UsbDevice& device) { return device.serial != address.name; });
    // One that has a number of its own is found wherever it is plugged in.
    if (!address.usbPort.empty() && (address.name.empty() || devices.size() > 1))
        std::erase_if(devices, [&](const UsbDevice& device) { return device.port != address.usbPort; });
    return devices;
}

std::vector<std::string> usbNamesOf(const std::vector<UsbDevice>& devices)
{
    std::vector<std::string> names;
    for (const UsbDevice& device : devices) {
        const auto alike = std::count_if(devices.begin(), devices.end(),
                                         [&](const UsbDevice& other) { return other.serial == device.serial; });
        const bool isItsOwn = !device.serial.empty() && alike == 1;
        names.push_back(isItsOwn ? device.serial : device.serial + "@" + device.port);
    }
    return names;
}

}  // namespace planewright
