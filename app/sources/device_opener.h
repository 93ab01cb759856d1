// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <stop_token>
#include <string>
#include <vector>

#include "devices/clock.h"
#include "devices/device_address.h"
#include "devices/laser.h"
#include "devices/scip/scip_connect.h"
#include "devices/tilt_unit.h"
#include "devices/transport/transport.h"
#include "devices/transport/usb_bus.h"

namespace planewright {

/// How devices are opened, the same for all of a scan.
struct DeviceOptions {
    /// Folder in which every dialogue with a device is recorded, byte by byte; empty: none is.
    std::string dialogueFolder;
    /// Told what is waited for while a laser starts up, in the thread that waits.
    ScipProgress progress;
};

/// Opens lasers and tilt units by what people call them. Any thread; a device takes seconds where it is ill.
class DeviceOpener {
public:
    explicit DeviceOpener(const Clock& clock, DeviceOptions options = {});

    /// Told on the bus's thread when a USB device has come or gone: it only takes note.
    void onUsbChange(std::function<void()> changed);

    /// The laser of an address, connected: it answers, and is the one that was asked for. Of several that USB cannot
    /// tell apart each is asked for its number.
    ///
    /// Errors: NoDevice, naming those that are there; Usage for an address of something else; Interrupted.
    Result<std::unique_ptr<Laser>> openLaser(const DeviceAddress& address, const std::stop_token& stop);

    /// The servo or board of an address, connected; nothing moves. Errors as for openLaser().
    Result<std::unique_ptr<TiltUnit>> openTiltUnit(const DeviceAddress& address, const std::stop_token& stop);

    /// The USB devices that there are; empty where this machine has no USB.
    std::vector<UsbDevice> usbDevices();
    /// A laser that is on a USB device, connected. Errors (NoDevice): it cannot be opened, or does not answer as one.
    Result<std::unique_ptr<Laser>> openLaserOn(const UsbDevice& device, const std::stop_token& stop);

private:
    Result<std::shared_ptr<UsbBus>> bus();
    Result<std::unique_ptr<Laser>> openUsbLaser(const std::string& serial, const std::stop_token& stop);
    Result<UsbDevice> findUsb(const DeviceAddress& address);
    Result<std::unique_ptr<Transport>> openLink(const DeviceAddress& address, const std::stop_token& stop);
    Result<std::unique_ptr<Transport>> openUsb(const DeviceAddress& address);
    /// The link itself, or one that is recorded as well.
    Result<std::unique_ptr<Transport>> recorded(std::unique_ptr<Transport> link, const std::string& device);
    Result<std::unique_ptr<Laser>> connectLaser(std::unique_ptr<Transport> link, const std::stop_token& stop);

    const Clock& clock_;
    DeviceOptions options_;
    std::mutex mutex_;
    std::shared_ptr<UsbBus> bus_;
    std::function<void()> changed_;
    int dialogues_ = 0;
};

/// How a tilt unit is mounted where its address does not say otherwise: its middle looks level, it may go from straight
/// down over level to straight up behind, at 120° a second at most.
TiltMounting mountingOf(const DeviceAddress& address);

/// True for a USB device that is a laser, as far as USB can tell.
bool isUsbLaser(const UsbDevice& device);

}  // namespace planewright
