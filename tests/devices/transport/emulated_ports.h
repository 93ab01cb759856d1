// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>
#include <string>

namespace planewright {

/// The serial ports of a machine, as programs in this process see them: /sys and udev come from umockdev. Needs its
/// preload library. One at a time.
class EmulatedPorts {
public:
    EmulatedPorts();
    ~EmulatedPorts();
    EmulatedPorts(const EmulatedPorts&) = delete;
    EmulatedPorts& operator=(const EmulatedPorts&) = delete;

    /// Adds a USB device with a port "ttyACM0", as udev describes them. Numbers are hexadecimal: "15d1".
    /// umockdev does not take a name again that was removed.
    void add(const std::string& port, const std::string& vendorId, const std::string& productId,
             const std::string& vendor, const std::string& product, const std::string& serial);
    void remove(const std::string& port);

private:
    struct Testbed;
    std::unique_ptr<Testbed> testbed_;
};

}  // namespace planewright
