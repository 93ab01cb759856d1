// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/transport/usb_handle.h"

#include <libusb.h>
#include <vector>

#include "devices/transport/port_holder.h"
#include "devices/transport/usb_error.h"
#include "devices/transport/usb_sysfs.h"

namespace planewright {

namespace {

constexpr unsigned kControlTimeout = 500;  // [ms]

}  // namespace

Result<std::unique_ptr<UsbHandle>> UsbHandle::open(std::shared_ptr<UsbBus> bus, const UsbDevice& device,
                                                   std::function<void()> onGone)
{
    const auto loan = bus->lend(device, std::move(onGone));
    if (!loan)
        return tl::unexpected<Error>(loan.error());
    std::unique_ptr<UsbHandle> self{new UsbHandle(std::move(bus), device)};
    self->lent_ = loan->device;
    self->layout_ = loan->layout;
    UsbDevice now = device;  // the list may be old: who has it now?
    now.driver = usbDriver(device.port, self->layout_.configuration, self->layout_.dataInterface);
    now.serialPort = usbSerialPort(device.port, self->layout_.configuration, self->layout_.controlInterface);
    int status = libusb_open(self->lent_, &self->handle_);
    // To take it from a kernel driver is to pull the cable out for whoever uses the driver's serial port.
    const auto holder =
        status == LIBUSB_SUCCESS && !now.serialPort.empty() ? holderOrLockOf(now.serialPort) : std::nullopt;
    now.holder = holder ? holder->describe() : std::string{};
    if (holder)
        status = LIBUSB_ERROR_BUSY;
    else if (status == LIBUSB_SUCCESS)
        status = self->claim();
    if (status == LIBUSB_SUCCESS)
        return self;
    return tl::unexpected<Error>(usbOpenError(now, status));
}

UsbHandle::~UsbHandle()
{
    if (hasData_ && layout_.dataInterface != layout_.controlInterface)
        libusb_release_interface(handle_, layout_.dataInterface);
    if (hasControl_)
        libusb_release_interface(handle_, layout_.controlInterface);
    if (handle_ != nullptr)
        libusb_close(handle_);
    bus_->giveBack(lent_);
    libusb_unref_device(lent_);
}

int UsbHandle::claim()
{
    // Where the system cannot do this, claiming fails and says so.
    libusb_set_auto_detach_kernel_driver(handle_, 1);
    int status = libusb_claim_interface(handle_, layout_.controlInterface);
    hasControl_ = status == LIBUSB_SUCCESS;
    if (hasControl_ && layout_.dataInterface != layout_.controlInterface)
        status = libusb_claim_interface(handle_, layout_.dataInterface);
    hasData_ = status == LIBUSB_SUCCESS;
    return status;
}

int UsbHandle::control(const UsbRequest& request, std::span<const std::uint8_t> data) const
{
    std::vector<std::uint8_t> bytes(data.begin(), data.end());  // libusb takes no const bytes
    const int count = libusb_control_transfer(handle_, request.type, request.request, request.value, request.index,
                                              bytes.data(), static_cast<std::uint16_t>(bytes.size()), kControlTimeout);
    return count < 0 ? count : LIBUSB_SUCCESS;
}

}  // namespace planewright
