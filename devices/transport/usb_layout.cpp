// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/transport/usb_layout.h"

#include <algorithm>
#include <array>
#include <libusb.h>
#include <span>

namespace planewright {

namespace {

constexpr std::uint8_t kAbstractControlModel = 0x02;    // subclass of communications interfaces, CDC 1.2 table 4
constexpr std::uint8_t kClassSpecificInterface = 0x24;  // CDC 1.2 table 12
constexpr std::uint8_t kUnionDescriptor = 0x06;         // CDC 1.2 table 13

/// The first alternate setting of every interface: what a device has when it was just plugged in.
const libusb_interface_descriptor* findInterface(const libusb_config_descriptor& configuration, int number)
{
    for (const libusb_interface& each : std::span{configuration.interface, configuration.bNumInterfaces}) {
        if (each.num_altsetting > 0 && each.altsetting->bInterfaceNumber == number)
            return each.altsetting;
    }
    return nullptr;
}

/// The interface that a union descriptor names for the data, if there is one.
std::optional<int> unitedInterface(const libusb_interface_descriptor& control)
{
    std::span rest{control.extra, static_cast<std::size_t>(std::max(control.extra_length, 0))};
    while (rest.size() >= 2 && rest[0] >= 2 && rest[0] <= rest.size()) {
        if (rest[0] >= 5 && rest[1] == kClassSpecificInterface && rest[2] == kUnionDescriptor)
            return rest[4];
        rest = rest.subspan(rest[0]);
    }
    return std::nullopt;
}

bool isBulkPacketSize(std::size_t size)
{
    constexpr std::array<std::size_t, 6> kSizes{8, 16, 32, 64, 512, 1024};  // USB 2.0 5.8.3, USB 3.2 8.12.1.2
    return std::find(kSizes.begin(), kSizes.end(), size) != kSizes.end();
}

/// Fills in the endpoints of an interface; false where it lacks one.
bool findEndpoints(const libusb_interface_descriptor& data, UsbLayout& layout)
{
    for (const libusb_endpoint_descriptor& each : std::span{data.endpoint, data.bNumEndpoints}) {
        if ((each.bmAttributes & LIBUSB_TRANSFER_TYPE_MASK) != LIBUSB_TRANSFER_TYPE_BULK)
            continue;
        const bool isIn = (each.bEndpointAddress & LIBUSB_ENDPOINT_DIR_MASK) == LIBUSB_ENDPOINT_IN;
        std::uint8_t& endpoint = isIn ? layout.in : layout.out;
        if (endpoint != 0)
            continue;
        endpoint = each.bEndpointAddress;
        if (isIn)
            layout.packetSize = each.wMaxPacketSize & 0x7FFU;
    }
    layout.dataInterface = data.bInterfaceNumber;
    return layout.in != 0 && layout.out != 0 && isBulkPacketSize(layout.packetSize);
}

std::optional<UsbLayout> cdcLayout(const libusb_device_descriptor& device,
                                   const libusb_config_descriptor& configuration)
{
    for (const libusb_interface& each : std::span{configuration.interface, configuration.bNumInterfaces}) {
        if (each.num_altsetting < 1 || each.altsetting->bInterfaceClass != LIBUSB_CLASS_COMM)
            continue;
        const libusb_interface_descriptor& control = *each.altsetting;
        // Network adapters are of this class too. What a laser's subclass is, no document tells.
        if (control.bInterfaceSubClass != kAbstractControlModel && device.idVendor != kHokuyoVendor)
            continue;
        const libusb_interface_descriptor* data =
            findInterface(configuration, unitedInterface(control).value_or(control.bInterfaceNumber + 1));
        UsbLayout layout{.kind = UsbKind::CdcAcm,
                         .configuration = configuration.bConfigurationValue,
                         .controlInterface = control.bInterfaceNumber};
        if (data != nullptr && data->bInterfaceClass == LIBUSB_CLASS_DATA && findEndpoints(*data, layout))
            return layout;
    }
    return std::nullopt;
}

std::optional<UsbLayout> ftdiLayout(const libusb_config_descriptor& configuration)
{
    const libusb_interface_descriptor* only = findInterface(configuration, 0);
    UsbLayout layout{.kind = UsbKind::Ftdi, .configuration = configuration.bConfigurationValue};
    if (only == nullptr || only->bInterfaceClass != LIBUSB_CLASS_VENDOR_SPEC || !findEndpoints(*only, layout))
        return std::nullopt;
    return layout;
}

}  // namespace

std::optional<UsbLayout> usbLayout(const libusb_device_descriptor& device,
                                   const libusb_config_descriptor& configuration)
{
    if (device.idVendor == kFtdiVendor && (device.idProduct == kFt232r || device.idProduct == kFt232h))
        return ftdiLayout(configuration);
    return cdcLayout(device, configuration);
}

}  // namespace planewright
