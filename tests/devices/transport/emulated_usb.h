// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>
#include <string>
#include <vector>

#include "tests/devices/transport/emulated_usb_device.h"

namespace planewright {

/// A machine's USB in this process: what libusb sees of /sys and /dev comes from umockdev, and requests on nodes are
/// answered by EmulatedUsbDevice. Needs umockdev's preload library (planewright_usb_test in CMake). One at a time.
class EmulatedUsb {
public:
    EmulatedUsb();
    ~EmulatedUsb();
    EmulatedUsb(const EmulatedUsb&) = delete;
    EmulatedUsb& operator=(const EmulatedUsb&) = delete;

    /// Plugs a device into port "1-N" of the machine, at an address that was not used for long.
    std::shared_ptr<EmulatedUsbDevice> plug(const UsbModel& model, int port);
    /// Plugs one in again that was pulled out; its address is another than before.
    void plugAgain(const std::shared_ptr<EmulatedUsbDevice>& device, int port);

    /// Who tells first that a device is gone.
    enum class Unplugging {
        TransfersFirst,  ///< as Linux does it
        EventFirst,
        TransfersOnly,  ///< as in a container, where nobody tells of devices
    };
    void unplug(const std::shared_ptr<EmulatedUsbDevice>& device, Unplugging order = Unplugging::TransfersFirst);

    /// Tells of a device again that is there already.
    void announceAgain(const std::shared_ptr<EmulatedUsbDevice>& device);

    /// The file that stands for a serial port of UsbModel::serialPort, for programs that know nothing of the testbed.
    std::string fileOf(const std::string& serialPort) const;

    /// Its address now.
    int address(const std::shared_ptr<EmulatedUsbDevice>& device) const;

    /// Requests of programs on all nodes up to now: what waiting costs.
    long requests() const;

private:
    class Testbed;
    std::unique_ptr<Testbed> testbed_;
};

}  // namespace planewright
