// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/transport/usb_probe.h"

#include <array>
#include <libusb.h>
#include <span>
#include <string>

#include "devices/transport/port_holder.h"
#include "devices/transport/usb_sysfs.h"

namespace planewright {

namespace {

/// "1-4.2": the bus and the ports on the way from it.
std::string portOf(libusb_device* device)
{
    std::array<std::uint8_t, 7> ports{};  // USB has no more hubs in a row
    const int count = libusb_get_port_numbers(device, ports.data(), static_cast<int>(ports.size()));
    std::string path = std::to_string(libusb_get_bus_number(device));
    for (int i = 0; i < count; ++i)
        path += (i == 0 ? "-" : ".") + std::to_string(ports[static_cast<std::size_t>(i)]);
    return path;
}

/// Reads what the system does not tell. A device that leaves one question without answer is not asked again.
void askForStrings(libusb_device_handle* handle, const libusb_device_descriptor& descriptor, UsbDevice& entry)
{
    const std::array<std::pair<std::uint8_t, std::string*>, 3> wanted{{{descriptor.iManufacturer, &entry.manufacturer},
                                                                       {descriptor.iProduct, &entry.productName},
                                                                       {descriptor.iSerialNumber, &entry.serial}}};
    for (const auto& [index, text] : wanted) {
        if (index == 0 || !text->empty())
            continue;
        std::array<unsigned char, 128> bytes{};
        const int count =
            libusb_get_string_descriptor_ascii(handle, index, bytes.data(), static_cast<int>(bytes.size()));
        if (count < 0)
            return;
        *text = printable(std::string(bytes.begin(), bytes.begin() + count));
    }
}

}  // namespace

std::optional<IdentifiedUsbDevice> identifyUsbDevice(libusb_device* device)
{
    libusb_device_descriptor descriptor{};
    libusb_config_descriptor* configuration = nullptr;
    if (libusb_get_device_descriptor(device, &descriptor) != LIBUSB_SUCCESS ||
        libusb_get_active_config_descriptor(device, &configuration) != LIBUSB_SUCCESS)
        return std::nullopt;
    const auto layout = usbLayout(descriptor, *configuration);
    libusb_free_config_descriptor(configuration);
    if (!layout)
        return std::nullopt;
    return IdentifiedUsbDevice{.entry = {.vendor = descriptor.idVendor,
                                         .product = descriptor.idProduct,
                                         .bus = libusb_get_bus_number(device),
                                         .address = libusb_get_device_address(device),
                                         .port = portOf(device),
                                         .manufacturer = {},
                                         .productName = {},
                                         .serial = {},
                                         .kind = layout->kind,
                                         .access = UsbAccess::Openable,
                                         .driver = {},
                                         .serialPort = {},
                                         .holder = {}},
                               .layout = *layout};
}

bool probeUsbDevice(libusb_device* device, const UsbLayout& layout, UsbDevice& entry)
{
    entry.manufacturer = usbAttribute(entry.port, "manufacturer");
    entry.productName = usbAttribute(entry.port, "product");
    entry.serial = usbAttribute(entry.port, "serial");
    entry.driver = usbDriver(entry.port, layout.configuration, layout.dataInterface);
    entry.serialPort = usbSerialPort(entry.port, layout.configuration, layout.controlInterface);
    const auto holder = entry.serialPort.empty() ? std::nullopt : holderOf(entry.serialPort);
    entry.holder = holder ? holder->describe() : std::string{};
    if (entry.driver == "usbfs" || holder)
        entry.access = UsbAccess::Busy;
    if (entry.access == UsbAccess::Busy)
        return true;

    libusb_device_descriptor descriptor{};
    libusb_device_handle* handle = nullptr;
    const int status = libusb_open(device, &handle);
    if (status == LIBUSB_ERROR_ACCESS)
        entry.access = UsbAccess::Denied;
    if (status != LIBUSB_SUCCESS)
        return status != LIBUSB_ERROR_NO_DEVICE;
    if (libusb_get_device_descriptor(device, &descriptor) == LIBUSB_SUCCESS)
        askForStrings(handle, descriptor, entry);
    libusb_close(handle);
    return true;
}

}  // namespace planewright
