// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>

#include "core/types/error.h"
#include "devices/clock.h"
#include "devices/transport/transport.h"
#include "devices/transport/usb_bus.h"
#include "devices/transport/usb_device.h"

namespace planewright {

/// Opens a modem class device (CDC-ACM), such as a laser or a control board, without the kernel's driver.
///
/// It is told a line of 115200 baud, 8N1, and that a terminal is ready. Neither means anything to a device without a
/// real line, and one that refuses them is used all the same.
///
/// Errors (NoDevice): no right, another program, gone, no answer; with what to do.
Result<std::unique_ptr<Transport>> openUsbCdc(std::shared_ptr<UsbBus> bus, const UsbDevice& device, const Clock& clock);

}  // namespace planewright
