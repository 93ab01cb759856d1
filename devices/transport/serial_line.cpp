// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/transport/serial_line.h"

#include <array>
#include <cerrno>
#include <fcntl.h>
#include <filesystem>
#include <grp.h>
#include <sys/file.h>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <system_error>
#include <unistd.h>
#include <utility>

#include "devices/transport/descriptor.h"
#include "devices/transport/descriptor_link.h"
#include "devices/transport/serial_settings.h"
#include "devices/transport/usb_error.h"

namespace planewright {

namespace {

constexpr const char* kBusy =
    "another program holds the port; end it (ModemManager lets go some seconds after a device was plugged in)";

/// The group that may use a port: "dialout" on Debian.
std::string groupOf(const std::string& path)
{
    struct stat status = {};
    group entry{};
    group* found = nullptr;
    std::array<char, 4096> text{};
    if (::stat(path.c_str(), &status) != 0 || status.st_gid == 0 ||
        ::getgrgid_r(status.st_gid, &entry, text.data(), text.size(), &found) != 0 || found == nullptr)
        return "dialout";
    return found->gr_name;
}

/// The rules for udev are for ports that came with a plug.
bool isOfUsb(const std::string& path)
{
    std::error_code error;
    const std::filesystem::path real = std::filesystem::canonical(path, error);
    const std::string name = (error ? std::filesystem::path{path} : real).filename().string();
    return name.starts_with("ttyUSB") || name.starts_with("ttyACM");
}

/// Pseudo terminals have these numbers on Linux.
bool isPseudoTerminal(const Descriptor& line)
{
    constexpr unsigned kFirst = 136;
    constexpr unsigned kLast = 143;
    struct stat status = {};
    return ::fstat(line.number(), &status) == 0 && major(status.st_rdev) >= kFirst && major(status.st_rdev) <= kLast;
}

/// False where another program holds the line.
bool takeForOurselves(const Descriptor& line)
{
    // A lock holds back programs that look for it, and those of root; the mark all others. A pseudo terminal would keep
    // the mark of a program that was killed for as long as it lives.
    if (::flock(line.number(), LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK)
        return false;
    if (!isPseudoTerminal(line))
        ::ioctl(line.number(), TIOCEXCL);
    return true;
}

std::string serialEndText(int /*error*/, bool /*anythingCame*/)
{
    return "the device is gone; plug it in again";
}

}  // namespace

Result<std::unique_ptr<Transport>> openSerialLine(const std::string& path, int baud, const Clock& clock)
{
    const auto refuse = [&](const std::string& why) { return fail(ErrorCode::NoDevice, path + ": " + why); };
    Descriptor line{::open(path.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC)};
    if (!line.isOpen())
        return refuse(serialTroubleText(errno, path));
    if (::isatty(line.number()) == 0)
        return refuse(serialTroubleText(ENOTTY, path));
    if (!takeForOurselves(line))
        return refuse(kBusy);
    if (!setRawLine(line.number(), baud))
        return refuse("cannot be set to " + std::to_string(baud) +
                      " bit/s; give a speed that it can have with ?baud=, or use another adapter");
    raiseModemLines(line.number());
    return DescriptorLink::open(std::move(line), path, serialEndText, clock);
}

bool isForbiddenPort(const std::string& path)
{
    return ::access(path.c_str(), R_OK | W_OK) != 0 && (errno == EACCES || errno == EPERM);
}

std::string serialPermissionCommand(const std::string& path)
{
    return "sudo usermod -aG " + groupOf(path) + " \"$USER\"";
}

std::string serialTroubleText(int error, const std::string& path)
{
    switch (error) {
        case ENOENT:
        case ENODEV:
        case ENXIO:
            return "there is no such port; plug the device in, and see 'planewright-cli devices' for what is there";
        case EACCES:
        case EPERM:
            return "you have no right to open it; run '" + serialPermissionCommand(path) + "' and log in again" +
                   (isOfUsb(path) ? ", or install the rule for udev: " + usbPermissionCommand() : "");
        case EBUSY:
            return kBusy;
        case ENOTTY:
        case EISDIR:
        case EINVAL:
            return "is no serial port; see 'planewright-cli devices' for what is there";
        default:
            return "cannot be opened (" + std::generic_category().message(error) + ")";
    }
}

}  // namespace planewright
