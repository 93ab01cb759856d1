// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <arpa/inet.h>
#include <chrono>
#include <cstdint>
#include <netinet/in.h>
#include <poll.h>
#include <string>
#include <string_view>
#include <sys/socket.h>
#include <vector>

#include "devices/clock.h"
#include "devices/transport/descriptor.h"
#include "devices/transport/transport.h"

namespace planewright {

/// Longer than anything takes on a machine that is busy: a test that waits so long has failed.
inline constexpr std::chrono::seconds kPatience{60};

/// A socket at a port of its own on this machine, which listens or does not.
class TestListener {
public:
    explicit TestListener(int backlog = 8) : socket_(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0))
    {
        sockaddr_in address{};
        address.sin_family = AF_INET;
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        ::bind(socket_.number(), reinterpret_cast<const sockaddr*>(&address), sizeof address);
        socklen_t size = sizeof address;
        ::getsockname(socket_.number(), reinterpret_cast<sockaddr*>(&address), &size);
        port_ = ntohs(address.sin_port);
        if (backlog >= 0)
            ::listen(socket_.number(), backlog);
    }

    std::uint16_t port() const { return port_; }

    /// The next connection; none where nobody comes.
    Descriptor accept() const
    {
        pollfd waiting{socket_.number(), POLLIN, 0};
        const auto patience = std::chrono::milliseconds{kPatience};
        return Descriptor{::poll(&waiting, 1, static_cast<int>(patience.count())) == 1
                              ? ::accept4(socket_.number(), nullptr, nullptr, SOCK_CLOEXEC)
                              : -1};
    }

private:
    Descriptor socket_;
    std::uint16_t port_ = 0;
};

/// A plain connection to a port of this machine.
inline Descriptor connectPlainly(std::uint16_t port)
{
    Descriptor socket{::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)};
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    address.sin_port = htons(port);
    if (::connect(socket.number(), reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0)
        return {};
    return socket;
}

inline std::vector<std::uint8_t> asBytes(std::string_view text)
{
    return {text.begin(), text.end()};
}

/// Writes a text to a descriptor, all of it.
inline bool sendText(const Descriptor& to, std::string_view text)
{
    return ::write(to.number(), text.data(), text.size()) == static_cast<ssize_t>(text.size());
}

/// What comes from a descriptor until there are `count` bytes, its end, or patience is over.
inline std::string receiveText(const Descriptor& from, std::size_t count)
{
    std::string text;
    while (text.size() < count) {
        pollfd waiting{from.number(), POLLIN, 0};
        const auto patience = std::chrono::milliseconds{kPatience};
        char buffer[4096];
        if (::poll(&waiting, 1, static_cast<int>(patience.count())) != 1)
            break;
        const ssize_t got = ::read(from.number(), buffer, std::min(sizeof buffer, count - text.size()));
        if (got <= 0)
            break;
        text.append(buffer, static_cast<std::size_t>(got));
    }
    return text;
}

/// What a link gives until there are `count` bytes or patience is over; an error's text in brackets at its end.
inline std::string readText(Transport& link, std::size_t count)
{
    std::string text;
    const auto deadline = steadyClock().now() + kPatience;
    while (text.size() < count && steadyClock().now() < deadline) {
        std::uint8_t buffer[4096];
        const auto arrival = link.read({buffer, std::min(sizeof buffer, count - text.size())}, deadline, {});
        if (!arrival)
            return text + "<" + arrival.error().message + ">";
        text.append(buffer, buffer + arrival->count);
    }
    return text;
}

}  // namespace planewright
