// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/sources/found_devices.h"

#include "devices/transport/serial_ports.h"
#include "devices/transport/usb_error.h"

namespace planewright {

namespace {

std::string joined(const std::string& first, const std::string& second)
{
    return first + (first.empty() || second.empty() ? "" : " ") + second;
}

/// Empty where a device may be opened.
std::string problemOf(const UsbDevice& device)
{
    switch (device.access) {
        case UsbAccess::Openable:
            break;
        case UsbAccess::Denied:
            return "you may not use it yet; once, run: " + usbPermissionCommand();
        case UsbAccess::Busy:
            return "another program uses it; close that one";
    }
    return {};
}

FoundDevice laserOn(const UsbDevice& device, DeviceOpener& opener, bool asks, const std::stop_token& stop)
{
    FoundDevice found{FoundDevice::Kind::Laser, "usb:", joined(device.manufacturer, device.productName),
                      problemOf(device)};
    found.name += (found.name.empty() ? "" : ", ") + device.name();
    if (!asks || !found.problem.empty())
        return found;
    const auto laser = opener.openLaserOn(device, stop);
    if (!laser) {
        found.problem = laser.error().message;
        return found;
    }
    const LaserIdentity& identity = (*laser)->identity();
    found.address += identity.serial;
    found.name =
        identity.product + ", number " + identity.serial + ", firmware " + identity.firmware + ", " + device.name();
    return found;
}

FoundDevice otherOn(const UsbDevice& device)
{
    const bool isAdapter = device.kind == UsbKind::Ftdi;
    const std::string name = joined(device.manufacturer, device.productName);
    return {isAdapter ? FoundDevice::Kind::ServoAdapter : FoundDevice::Kind::ControlBoard,
            (isAdapter ? "dynamixel:usb:" : "board:usb:") + device.serial,
            name + (name.empty() ? "" : ", ") + device.name(), problemOf(device)};
}

}  // namespace

std::string nameOf(FoundDevice::Kind kind)
{
    switch (kind) {
        case FoundDevice::Kind::Laser:
            return "laser";
        case FoundDevice::Kind::ServoAdapter:
            return "servo adapter";
        case FoundDevice::Kind::ControlBoard:
            return "control board";
        case FoundDevice::Kind::SerialPort:
            break;
    }
    return "serial port";
}

std::vector<FoundDevice> findDevices(DeviceOpener& opener, bool asks, const std::stop_token& stop)
{
    std::vector<FoundDevice> found;
    for (const UsbDevice& device : opener.usbDevices()) {
        if (stop.stop_requested())
            return found;
        found.push_back(isUsbLaser(device) ? laserOn(device, opener, asks, stop) : otherOn(device));
    }
    for (const SerialPort& port : serialPorts())
        found.push_back({FoundDevice::Kind::SerialPort, "serial:" + port.path, joined(port.vendor, port.product), {}});
    return found;
}

}  // namespace planewright
