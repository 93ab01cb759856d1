// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>

#include "core/types/error.h"
#include "devices/transport/usb_bus.h"
#include "devices/transport/usb_device.h"
#include "devices/transport/usb_layout.h"

struct libusb_device_handle;

namespace planewright {

/// A request to a device that carries its answer in no data: CDC's and FTDI's settings.
struct UsbRequest {
    std::uint8_t type = 0;  ///< bmRequestType, to the device
    std::uint8_t request = 0;
    std::uint16_t value = 0;
    std::uint16_t index = 0;
};

/// A device that is open here with its interfaces claimed, taken from the kernel's driver for that time. Gives all of
/// it back in order when it ends: data interface, control interface, handle, and the device to the bus.
class UsbHandle {
public:
    /// `onGone`: see UsbBus::lend(). Errors (NoDevice): no right, another program, gone; usbOpenError() says what to
    /// do. A device whose serial port of the kernel's driver another program has open is left to that program.
    static Result<std::unique_ptr<UsbHandle>> open(std::shared_ptr<UsbBus> bus, const UsbDevice& device,
                                                   std::function<void()> onGone);
    ~UsbHandle();
    UsbHandle(const UsbHandle&) = delete;
    UsbHandle& operator=(const UsbHandle&) = delete;

    libusb_device_handle* get() const { return handle_; }
    const UsbLayout& layout() const { return layout_; }
    const UsbDevice& device() const { return device_; }

    /// Sends a request and waits until the device has taken it, half a second at most; gives libusb's status.
    int control(const UsbRequest& request, std::span<const std::uint8_t> data = {}) const;

private:
    UsbHandle(std::shared_ptr<UsbBus> bus, UsbDevice device) : bus_(std::move(bus)), device_(std::move(device)) {}
    int claim();

    std::shared_ptr<UsbBus> bus_;
    UsbDevice device_;
    UsbLayout layout_;
    libusb_device* lent_ = nullptr;
    libusb_device_handle* handle_ = nullptr;
    bool hasControl_ = false;
    bool hasData_ = false;
};

}  // namespace planewright
