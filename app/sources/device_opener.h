// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <set>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

#include "app/sources/device_access.h"
#include "devices/clock.h"
#include "devices/fault_log.h"
#include "devices/scip/scip_connect.h"
#include "devices/transport/transport.h"
#include "devices/transport/usb_bus.h"

namespace planewright {

/// How devices are opened, the same for all of a scan.
struct DeviceOptions {
    /// Folder in which every dialogue with a device is recorded, byte by byte, in a file of its own each time that it
    /// is opened: laser-1.dialogue, tilt-1.dialogue, laser-2.dialogue. Made where it is not there. Empty: none is.
    std::string dialogueFolder;
    /// Told what is waited for while a laser starts up, in the thread that waits.
    ScipProgress progress;
};

/// Opens lasers and tilt units by what people call them.
class DeviceOpener : public DeviceAccess {
public:
    explicit DeviceOpener(const Clock& clock, DeviceOptions options = {});

    /// Told on the bus's thread when a USB device has come or gone: it only takes note.
    void onUsbChange(std::function<void()> changed);

    Result<std::vector<UsbDevice>> usbDevices() override;
    /// One that was opened before is looked for first where it was then.
    Result<std::unique_ptr<Laser>> openLaser(const DeviceAddress& address, const std::stop_token& stop) override;
    Result<std::unique_ptr<Laser>> openLaserOn(const UsbDevice& device, const std::stop_token& stop) override;
    Result<std::unique_ptr<TiltUnit>> openTiltUnit(const DeviceAddress& address, const std::stop_token& stop) override;

    /// What went wrong beside the devices since this was last asked: dialogues that are recorded no further. Any
    /// thread.
    std::vector<FaultRecord> takeLog() { return log_->take(); }

private:
    Result<std::shared_ptr<UsbBus>> bus();
    Result<std::unique_ptr<Laser>> openUsbLaser(const DeviceAddress& address, const std::stop_token& stop);
    Result<std::vector<UsbDevice>> lasersOf(const DeviceAddress& address);
    Result<UsbDevice> findUsb(const DeviceAddress& address);
    Result<std::unique_ptr<Transport>> openLink(const DeviceAddress& address, const std::stop_token& stop);
    Result<std::unique_ptr<Transport>> openTcp(const DeviceAddress& address, const std::stop_token& stop);
    Result<std::unique_ptr<Transport>> openUsb(const DeviceAddress& address);
    /// The link itself, or one that is recorded as well.
    Result<std::unique_ptr<Transport>> recorded(std::unique_ptr<Transport> link, const std::string& device);
    Result<std::unique_ptr<Laser>> connectLaser(std::unique_ptr<Transport> link, const std::stop_token& stop);

    const Clock& clock_;
    DeviceOptions options_;
    std::mutex mutex_;
    std::shared_ptr<UsbBus> bus_;
    std::function<void()> changed_;
    std::map<std::string, std::string> lastPorts_;              ///< by the number of a laser: where it was plugged in
    std::set<std::pair<std::string, std::uint16_t>> answered_;  ///< hosts and ports at which something has answered
    std::shared_ptr<FaultLog> log_ = std::make_shared<FaultLog>();  ///< of dialogues, whose threads use it, too
};

/// How a tilt unit is mounted and what it may do; where its address does not say otherwise its middle looks level, and
/// its limits are those of device_address.h.
TiltMounting mountingOf(const DeviceAddress& address);

}  // namespace planewright
