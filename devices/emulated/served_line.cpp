// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/emulated/served_line.h"

#include <array>
#include <cerrno>
#include <sys/socket.h>
#include <unistd.h>

#include "devices/emulated/served_pty.h"
#include "devices/emulated/served_tcp.h"

namespace planewright {

namespace {

bool meansLater(int error)
{
    return error == EAGAIN || error == EWOULDBLOCK || error == EINTR;
}

/// Sends what fits; −1 and errno as of write(2). A client that is gone must not end the program by a signal.
ssize_t sendSome(int descriptor, std::span<const std::uint8_t> bytes)
{
    const ssize_t sent = ::send(descriptor, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    return sent < 0 && errno == ENOTSOCK ? ::write(descriptor, bytes.data(), bytes.size()) : sent;
}

}  // namespace

Result<std::unique_ptr<ServedLine>> ServedLine::open(const std::string& where)
{
    constexpr std::string_view kTcp = "tcp:";
    if (where == "pty")
        return openServedPty();
    if (where.starts_with(kTcp))
        return openServedTcp(where.substr(kTcp.size()));
    return fail(ErrorCode::Usage, "'" + where + "': give tcp:PORT, with 0 for any, or pty");
}

void ServedLine::send(std::span<const std::uint8_t> bytes)
{
    if (!client().isOpen() || unsent_.size() + bytes.size() > kMostUnsent)
        return;
    unsent_.insert(unsent_.end(), bytes.begin(), bytes.end());
    // A client that is gone shows when it is read from.
    sendUnsent();
}

pollfd ServedLine::watchClient() const
{
    const int events = unsent_.empty() ? POLLIN : POLLIN | POLLOUT;
    return {client().number(), static_cast<short>(events), 0};
}

bool ServedLine::exchange(std::vector<std::uint8_t>& received)
{
    // Not without end: a client that never stops must leave the other devices their time.
    constexpr int kMostReads = 16;
    std::array<std::uint8_t, 4096> buffer{};
    for (int reads = 0; reads < kMostReads; ++reads) {
        const ssize_t count = ::read(client().number(), buffer.data(), buffer.size());
        if (count < 0 && meansLater(errno))
            break;
        if (count <= 0)
            return false;
        received.insert(received.end(), buffer.begin(), buffer.begin() + count);
    }
    return sendUnsent();
}

bool ServedLine::sendUnsent()
{
    while (!unsent_.empty()) {
        const ssize_t sent = sendSome(client().number(), unsent_);
        if (sent < 0)
            return meansLater(errno);
        unsent_.erase(unsent_.begin(), unsent_.begin() + sent);
    }
    return true;
}

}  // namespace planewright
