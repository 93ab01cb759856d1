// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/transport/port_holder.h"

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <sys/file.h>
#include <sys/stat.h>
#include <system_error>

#include "devices/transport/descriptor.h"
#include "devices/transport/usb_sysfs.h"

namespace planewright {

namespace {

namespace fs = std::filesystem;

bool isNumber(const std::string& text)
{
    return !text.empty() && std::all_of(text.begin(), text.end(), [](unsigned char c) { return std::isdigit(c) != 0; });
}

/// The same file, or another node of the same device.
bool isSame(const struct stat& a, const struct stat& b)
{
    const bool isDevice = S_ISCHR(a.st_mode) && S_ISCHR(b.st_mode) && a.st_rdev == b.st_rdev;
    return isDevice || (a.st_dev == b.st_dev && a.st_ino == b.st_ino);
}

bool hasOpen(const fs::path& process, const struct stat& node)
{
    std::error_code error;  // somebody else's: nothing may be seen of it
    for (fs::directory_iterator each(process / "fd", error), end; !error && each != end; each.increment(error)) {
        struct stat open {};
        if (stat(each->path().c_str(), &open) == 0 && isSame(open, node))
            return true;
    }
    return false;
}

}  // namespace

std::string PortHolder::describe() const
{
    return process == 0 ? "another program" : "the program " + program + " (process " + std::to_string(process) + ")";
}

std::optional<PortHolder> holderOf(const std::string& node)
{
    struct stat wanted {};
    if (stat(node.c_str(), &wanted) != 0)
        return std::nullopt;
    std::error_code error;
    for (fs::directory_iterator each("/proc", error), end; !error && each != end; each.increment(error)) {
        const std::string name = each->path().filename().string();
        if (!isNumber(name) || !hasOpen(each->path(), wanted))
            continue;
        std::string program;
        std::ifstream{each->path() / "comm"} >> program;
        return PortHolder{std::stoi(name), printable(program)};
    }
    return std::nullopt;
}

std::optional<PortHolder> holderOrLockOf(const std::string& node)
{
    if (auto holder = holderOf(node))
        return holder;
    const Descriptor file{::open(node.c_str(), O_RDWR | O_NONBLOCK | O_NOCTTY | O_CLOEXEC)};
    const bool isTaken =
        file.isOpen() ? flock(file.number(), LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK : errno == EBUSY;
    return isTaken ? std::optional{PortHolder{}} : std::nullopt;
}

}  // namespace planewright
