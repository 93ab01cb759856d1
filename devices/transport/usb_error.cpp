// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/transport/usb_error.h"

#include <filesystem>
#include <libusb.h>
#include <system_error>

namespace planewright {

namespace {

/// "usb 1-4 (15d1:0000 URG-Series USB Driver)".
std::string describe(const UsbDevice& device)
{
    constexpr char kDigits[] = "0123456789abcdef";
    std::string ids;
    for (const std::uint16_t id : {device.vendor, device.product}) {
        ids += ids.empty() ? "" : ":";
        for (const int shift : {12, 8, 4, 0})
            ids += kDigits[(id >> shift) & 0xF];
    }
    return device.name() + " (" + ids + (device.productName.empty() ? "" : " " + device.productName) + ")";
}

std::string busyMessage(const UsbDevice& device)
{
    if (!device.holder.empty())
        return device.holder + " has its serial port " + device.serialPort + " open (kernel driver " + device.driver +
               "); close that program, or let it be the one that scans";
    if (device.driver.empty() || device.driver == "usbfs")
        return "another program has it; close that program";
    return "the kernel driver " + device.driver +
           " does not give it up; use its serial port instead, or unload it: sudo "
           "modprobe -r " +
           device.driver;
}

}  // namespace

std::string usbPermissionCommand()
{
    std::error_code unused;
    const std::string installed = PLANEWRIGHT_UDEV_RULES;
    const std::string rules = std::filesystem::exists(installed, unused) ? installed : "packaging/60-planewright.rules";
    return "sudo cp " + rules + " /etc/udev/rules.d/ && sudo udevadm control --reload && sudo udevadm trigger";
}

Error usbOpenError(const UsbDevice& device, int status)
{
    std::string message;
    switch (status) {
        case LIBUSB_ERROR_ACCESS:
            message = "you have no right to open it; install the rule for udev: " + usbPermissionCommand();
            break;
        case LIBUSB_ERROR_BUSY:
            message = busyMessage(device);
            break;
        case LIBUSB_ERROR_NO_DEVICE:
        case LIBUSB_ERROR_NOT_FOUND:
            message = "it is not there any more; plug it in and look for devices again";
            break;
        case LIBUSB_ERROR_TIMEOUT:
            message = "it does not answer; pull it out, check its power and plug it in again";
            break;
        default:
            message = std::string{"it cannot be opened ("} + libusb_error_name(status) +
                      "); pull it out and plug it in again";
    }
    return {ErrorCode::NoDevice, describe(device) + ": " + message};
}

Error usbGone(const std::string& name)
{
    return {ErrorCode::DeviceLost, name + ": the device is gone; check its cable and plug it in again"};
}

Error usbClosed(const std::string& name)
{
    return {ErrorCode::DeviceLost, name + ": the link is closed; connect the device again"};
}

Error usbFailed(const std::string& name, const std::string& what)
{
    return {ErrorCode::DeviceLost, name + ": the USB link failed (" + what + "); check its cable and plug it in again"};
}

}  // namespace planewright
