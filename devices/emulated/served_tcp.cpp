// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/emulated/served_tcp.h"

#include <cerrno>
#include <netinet/tcp.h>
#include <string>
#include <sys/socket.h>
#include <system_error>
#include <utility>

#include "devices/address_text.h"
#include "devices/clock.h"
#include "devices/transport/host_address.h"

namespace planewright {

namespace {

class ServedTcp : public ServedLine {
public:
    ServedTcp(Descriptor listener, std::string address) : listener_(std::move(listener)), address_(std::move(address))
    {
    }

    std::string address() const override { return address_; }

    void watch(std::vector<pollfd>& watched) const override
    {
        watched.push_back({listener_.number(), POLLIN, 0});
        if (client_.isOpen())
            watched.push_back(watchClient());
    }

    std::vector<std::uint8_t> serve() override
    {
        std::vector<std::uint8_t> received;
        // Who has gone makes room for who comes: a client may come back at once.
        if (client_.isOpen() && !exchange(received))
            dropClient();
        takeIn();
        return received;
    }

    void setPluggedIn(bool isPluggedIn) override
    {
        isPluggedIn_ = isPluggedIn;
        if (!isPluggedIn)
            dropClient();
    }

protected:
    const Descriptor& client() const override { return client_; }

private:
    void takeIn()
    {
        constexpr int kMostAtOnce = 16;
        for (int i = 0; i < kMostAtOnce; ++i) {
            Descriptor guest{::accept4(listener_.number(), nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC)};
            if (!guest.isOpen())
                return;
            if (client_.isOpen() || !isPluggedIn_)
                continue;
            const int on = 1;
            ::setsockopt(guest.number(), IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
            client_ = std::move(guest);
        }
    }

    void dropClient()
    {
        client_.reset();
        forgetUnsent();
    }

    Descriptor listener_;
    std::string address_;
    Descriptor client_;
    bool isPluggedIn_ = true;
};

/// The port that a socket has been given; 0 where it has none.
std::uint16_t portOf(const Descriptor& socket)
{
    sockaddr_storage address{};
    socklen_t size = sizeof address;
    if (::getsockname(socket.number(), reinterpret_cast<sockaddr*>(&address), &size) != 0)
        return 0;
    // Both kinds of address have it at the same place.
    return ntohs(reinterpret_cast<const sockaddr_in*>(&address)->sin_port);
}

std::string listenTrouble(int error)
{
    if (error == EADDRINUSE)
        return "another program listens at this port; give another one, or 0 for any that is free";
    if (error == EACCES)
        return "ports below 1024 are for root; give another one, or 0 for any that is free";
    if (error == EADDRNOTAVAIL)
        return "this machine has no such address; leave it out to serve this machine alone";
    return "cannot be listened at (" + std::generic_category().message(error) + ")";
}

}  // namespace

Result<std::unique_ptr<ServedLine>> openServedTcp(std::string_view place)
{
    const std::string where = "tcp:" + std::string{place};
    std::string host = "127.0.0.1";
    std::uint16_t port = 0;
    const std::string problem =
        place.find(':') == std::string_view::npos ? readPort(place, 0, port) : readHostAndPort(place, 0, host, port);
    if (!problem.empty())
        return fail(ErrorCode::Usage, "'" + where + "': " + problem);
    const Clock& clock = steadyClock();
    const auto addresses = resolveHost(host, port, clock, clock.now() + std::chrono::seconds{3}, {});
    if (!addresses)
        return fail(addresses.error().code, where + ": " + addresses.error().message);
    const HostAddress& address = addresses->front();
    Descriptor listener{::socket(address.family(), SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, IPPROTO_TCP)};
    // A port that was served a moment ago may be served again.
    const int on = 1;
    ::setsockopt(listener.number(), SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
    if (::bind(listener.number(), address.get(), address.length) != 0 || ::listen(listener.number(), SOMAXCONN) != 0)
        return fail(ErrorCode::NoDevice, where + ": " + listenTrouble(errno));
    const std::string text = "tcp:" + hostText(host, portOf(listener));
    return std::make_unique<ServedTcp>(std::move(listener), text);
}

}  // namespace planewright
