// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/transport/usb_sysfs.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <system_error>

namespace planewright {

namespace {

std::filesystem::path folderOf(const std::string& device)
{
    return std::filesystem::path{"/sys/bus/usb/devices"} / device;
}

std::filesystem::path folderOfInterface(const std::string& port, int configuration, int interface)
{
    return folderOf(port + ":" + std::to_string(configuration) + "." + std::to_string(interface));
}

}  // namespace

std::string usbAttribute(const std::string& port, const std::string& attribute)
{
    std::ifstream file(folderOf(port) / attribute);
    std::array<char, 256> line{};  // a string descriptor has at most 126 characters, each up to 3 bytes here
    file.getline(line.data(), line.size());
    return printable(line.data());
}

std::string usbDriver(const std::string& port, int configuration, int interface)
{
    std::error_code unused;
    return printable(std::filesystem::read_symlink(folderOfInterface(port, configuration, interface) / "driver", unused)
                         .filename()
                         .string());
}

std::string usbSerialPort(const std::string& port, int configuration, int interface)
{
    // cdc_acm makes tty/ttyACM0 of an interface, the drivers of converters ttyUSB0/tty/ttyUSB0.
    const std::filesystem::path folder = folderOfInterface(port, configuration, interface);
    std::error_code error;
    for (std::filesystem::directory_iterator each(folder / "tty", error), end; !error && each != end;
         each.increment(error))
        return "/dev/" + each->path().filename().string();
    error.clear();
    for (std::filesystem::directory_iterator each(folder, error), end; !error && each != end; each.increment(error)) {
        const std::string name = each->path().filename().string();
        if (name.starts_with("ttyUSB"))
            return "/dev/" + name;
    }
    return {};
}

std::string printable(std::string text)
{
    const auto prints = [](char c) { return c >= ' ' && c <= '~'; };
    std::replace_if(
        text.begin(), text.end(), [&](char c) { return !prints(c); }, '?');
    return text;
}

}  // namespace planewright
