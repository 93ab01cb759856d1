// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tests/devices/transport/emulated_ports.h"

#include <stdexcept>
#include <umockdev.h>

namespace planewright {

namespace {

std::string usbPath(const std::string& port)
{
    return "/devices/pci0000:00/usb1/" + port;
}

}  // namespace

struct EmulatedPorts::Testbed {
    UMockdevTestbed* testbed = umockdev_testbed_new();

    Testbed() = default;
    Testbed(const Testbed&) = delete;
    Testbed& operator=(const Testbed&) = delete;
    ~Testbed() { g_object_unref(testbed); }
};

EmulatedPorts::EmulatedPorts() : testbed_(std::make_unique<Testbed>()) {}

EmulatedPorts::~EmulatedPorts() = default;

void EmulatedPorts::add(const std::string& port, const std::string& vendorId, const std::string& productId,
                        const std::string& vendor, const std::string& product, const std::string& serial)
{
    const std::string device = "P: " + usbPath(port) +
                               "\nE: SUBSYSTEM=usb\nE: DEVTYPE=usb_device\nA: idVendor=" + vendorId +
                               "\nA: idProduct=" + productId + "\n\n";
    std::string tty = "P: " + usbPath(port) + "/tty/" + port + "\nN: " + port + "\nE: SUBSYSTEM=tty\nE: DEVNAME=/dev/" +
                      port + "\nE: ID_VENDOR_ID=" + vendorId + "\nE: ID_MODEL_ID=" + productId +
                      "\nE: ID_VENDOR=" + vendor + "\nE: ID_MODEL=" + product + "\n";
    if (!serial.empty())
        tty += "E: ID_SERIAL_SHORT=" + serial + "\n";
    for (const std::string& description : {device, tty + "\n"}) {
        GError* error = nullptr;
        if (umockdev_testbed_add_from_string(testbed_->testbed, description.c_str(), &error) == FALSE)
            throw std::runtime_error{error->message};
    }
}

void EmulatedPorts::remove(const std::string& port)
{
    umockdev_testbed_remove_device(testbed_->testbed, ("/sys" + usbPath(port) + "/tty/" + port).c_str());
    umockdev_testbed_remove_device(testbed_->testbed, ("/sys" + usbPath(port)).c_str());
}

}  // namespace planewright
