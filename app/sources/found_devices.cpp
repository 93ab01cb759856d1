// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/sources/found_devices.h"

#include <array>
#include <string_view>

#include "app/sources/device_permission.h"
#include "devices/transport/serial_ports.h"

namespace planewright {

namespace {

std::string joined(const std::string& first, const std::string& second)
{
    return first + (first.empty() || second.empty() ? "" : " ") + second;
}

/// A device at USB, before anybody has asked it.
FoundDevice foundOn(const UsbDevice& device, FoundDevice::Kind kind, const std::string& address)
{
    FoundDevice found;
    found.kind = kind;
    found.address = address;
    found.name = joined(device.manufacturer, device.productName);
    found.name += (found.name.empty() ? "" : ", ") + device.name();
    found.port = device.port;
    if (const auto hindrance = hindranceOf(device)) {
        found.problem = hindrance->problem;
        found.cure = hindrance->cure;
    }
    return found;
}

/// `name` stands behind usb: as long as its number is not known.
FoundDevice laserOn(const UsbDevice& device, const std::string& name, const KnownLasers& known)
{
    FoundDevice found = foundOn(device, FoundDevice::Kind::Laser, "usb:" + name);
    if (const auto last = known.find(device.port); last != known.end()) {
        found.address = "usb:" + last->second;
        found.name += ", the last time number " + last->second;
    }
    return found;
}

void ask(const UsbDevice& device, DeviceAccess& access, const std::stop_token& stop, FoundDevice& found)
{
    const auto laser = access.openLaserOn(device, stop);
    if (!laser) {
        found.problem = laser.error().message;
        return;
    }
    const LaserIdentity& identity = (*laser)->identity();
    found.serial = identity.serial;
    found.address = "usb:" + identity.serial;
    found.name =
        identity.product + ", number " + identity.serial + ", firmware " + identity.firmware + ", " + device.name();
}

struct Wanted {
    DeviceAddress::Unit unit;
    FoundDevice::Kind kind;
    std::string_view word;
};
const std::array<Wanted, 3> kWanted{{{DeviceAddress::Unit::Laser, FoundDevice::Kind::Laser, ""},
                                     {DeviceAddress::Unit::Dynamixel, FoundDevice::Kind::ServoAdapter, "dynamixel:"},
                                     {DeviceAddress::Unit::Board, FoundDevice::Kind::ControlBoard, "board:"}}};

/// Devices of one kind; of one alone no name is needed, where it has none of its own.
void findOf(const Wanted& wanted, const std::vector<UsbDevice>& all, DeviceAccess& access, bool asks,
            const KnownLasers& known, const std::stop_token& stop, FoundDevices& found)
{
    DeviceAddress any;
    any.unit = wanted.unit;
    const std::vector<UsbDevice> devices = usbDevicesOf(any, all);
    const std::vector<std::string> names = usbNamesOf(devices);
    for (std::size_t i = 0; i < devices.size() && !stop.stop_requested(); ++i) {
        const bool needsNone = devices.size() == 1 && devices[i].serial.empty();
        const std::string name = needsNone ? "" : names[i];
        if (wanted.unit != DeviceAddress::Unit::Laser) {
            found.devices.push_back(foundOn(devices[i], wanted.kind, std::string{wanted.word} + "usb:" + name));
            continue;
        }
        // What USB calls the number of a laser is not the one that the laser goes by.
        found.devices.push_back(laserOn(devices[i], devices.size() == 1 ? "" : "@" + devices[i].port, known));
        if (asks && found.devices.back().problem.empty())
            ask(devices[i], access, stop, found.devices.back());
    }
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

FoundDevices findDevices(DeviceAccess& access, bool asks, const KnownLasers& known, const std::stop_token& stop)
{
    FoundDevices found;
    const auto devices = access.usbDevices();
    if (!devices)
        found.usbProblem = devices.error().message;
    for (const Wanted& wanted : kWanted) {
        if (devices)
            findOf(wanted, *devices, access, asks, known, stop, found);
    }
    for (const SerialPort& port : serialPorts()) {
        FoundDevice device;
        device.kind = FoundDevice::Kind::SerialPort;
        device.address = "serial:" + port.path;
        device.name = joined(port.vendor, port.product);
        if (const auto hindrance = hindranceOf(port.path)) {
            device.problem = hindrance->problem;
            device.cure = hindrance->cure;
        }
        found.devices.push_back(std::move(device));
    }
    return found;
}

KnownLasers withAsked(KnownLasers known, const FoundDevices& found)
{
    for (const FoundDevice& device : found.devices) {
        if (device.serial.empty())
            continue;
        // A laser is at one port at a time.
        std::erase_if(known, [&](const auto& at) { return at.second == device.serial; });
        known[device.port] = device.serial;
    }
    return known;
}

}  // namespace planewright
