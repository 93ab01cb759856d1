// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>
#include <stop_token>
#include <string>
#include <vector>

#include "core/types/error.h"
#include "devices/device_address.h"
#include "devices/laser.h"
#include "devices/tilt_unit.h"
#include "devices/transport/usb_device.h"

namespace planewright {

/// What is connected, and how it is opened. Any thread; a device takes seconds where it is ill.
class DeviceAccess {
public:
    virtual ~DeviceAccess() = default;

    /// The USB devices that there are. Errors (NoDevice): programs may not use USB on this machine.
    virtual Result<std::vector<UsbDevice>> usbDevices() = 0;

    /// The laser of an address, connected: it answers, and is the one that was asked for. Of several that USB cannot
    /// tell apart each is asked for its number.
    ///
    /// Errors: NoDevice, naming those that are there; Usage for an address of something else; Interrupted.
    virtual Result<std::unique_ptr<Laser>> openLaser(const DeviceAddress& address, const std::stop_token& stop) = 0;

    /// A laser that is on a USB device, connected. Errors (NoDevice): it cannot be opened, or does not answer as one.
    virtual Result<std::unique_ptr<Laser>> openLaserOn(const UsbDevice& device, const std::stop_token& stop) = 0;

    /// The servo or board of an address, connected; nothing moves. Errors as for openLaser().
    virtual Result<std::unique_ptr<TiltUnit>> openTiltUnit(const DeviceAddress& address,
                                                           const std::stop_token& stop) = 0;
};

/// What people call a kind of device: "laser", "servo adapter", "control board".
std::string nameOf(DeviceAddress::Unit unit);

/// True for a USB device that is a laser, as far as USB can tell.
bool isUsbLaser(const UsbDevice& device);

/// The USB devices that an address may mean: of its kind, at its port, and of its number where USB tells that.
std::vector<UsbDevice> usbDevicesOf(const DeviceAddress& address, std::vector<UsbDevice> devices);

/// What stands behind usb: for each of some devices of one kind: the number where it is its own, else the port as well,
/// "FT1@1-4" or "@1-4".
std::vector<std::string> usbNamesOf(const std::vector<UsbDevice>& devices);

}  // namespace planewright
