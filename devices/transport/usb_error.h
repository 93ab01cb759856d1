// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

#include "core/types/error.h"
#include "devices/transport/usb_device.h"

namespace planewright {

/// The shell command that lets users of this machine open the devices: copies the udev rule and applies it.
std::string usbPermissionCommand();

/// Why a device could not be opened, from a status of libusb: NoDevice, with what to do.
Error usbOpenError(const UsbDevice& device, int status);

/// The device of that name has been pulled out: DeviceLost.
Error usbGone(const std::string& name);

/// The transport of that name was closed here: DeviceLost.
Error usbClosed(const std::string& name);

/// A transfer of the device of that name failed, with libusb's name for it: DeviceLost.
Error usbFailed(const std::string& name, const std::string& what);

}  // namespace planewright
