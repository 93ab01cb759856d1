// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>

#include "devices/transport/usb_device.h"
#include "devices/transport/usb_layout.h"

struct libusb_device;

namespace planewright {

/// A device by its descriptors alone.
struct IdentifiedUsbDevice {
    UsbDevice entry;
    UsbLayout layout;
};

/// What a device is; empty: none that a transport can be opened on. Sends it nothing.
std::optional<IdentifiedUsbDevice> identifyUsbDevice(libusb_device* device);

/// Fills in what only looking tells: what it says of itself, whether it may be opened, and who has it. One that is
/// known to be busy is not opened. False where it is gone, though nobody has told of that yet.
bool probeUsbDevice(libusb_device* device, const UsbLayout& layout, UsbDevice& entry);

}  // namespace planewright
