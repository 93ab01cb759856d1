// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/transport/serial_ports.h"

#include <algorithm>

#include <QSerialPortInfo>

namespace planewright {

std::vector<SerialPort> serialPorts()
{
    std::vector<SerialPort> ports;
    for (const QSerialPortInfo& info : QSerialPortInfo::availablePorts()) {
        SerialPort port;
        port.path = info.systemLocation().toStdString();
        port.vendor = info.manufacturer().toStdString();
        port.product = info.description().toStdString();
        port.serial = info.serialNumber().toStdString();
        if (info.hasVendorIdentifier()) {
            port.usbVendor = info.vendorIdentifier();
            port.usbProduct = info.productIdentifier();
        }
        ports.push_back(std::move(port));
    }
    std::sort(ports.begin(), ports.end(), [](const SerialPort& a, const SerialPort& b) { return a.path < b.path; });
    return ports;
}

}  // namespace planewright
