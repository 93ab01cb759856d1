// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/transport/tcp_link.h"

#include <cerrno>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <utility>

#include "devices/transport/descriptor.h"
#include "devices/transport/descriptor_link.h"
#include "devices/transport/host_address.h"
#include "devices/transport/tcp_trouble.h"
#include "devices/transport/wake_event.h"

namespace planewright {

namespace {

// Probes after two seconds of silence and then each second: the third without an answer is at kSilenceLimit.
constexpr int kIdleSeconds = 2;
constexpr int kProbeSeconds = 1;
constexpr int kProbes = 3;
static_assert(std::chrono::seconds{kIdleSeconds + kProbes * kProbeSeconds} == kSilenceLimit);

void set(const Descriptor& socket, int level, int option, int value)
{
    // What a system does not know makes a link no worse than it was.
    ::setsockopt(socket.number(), level, option, &value, sizeof value);
}

void setOptions(const Descriptor& socket)
{
    set(socket, IPPROTO_TCP, TCP_NODELAY, 1);
    set(socket, SOL_SOCKET, SO_KEEPALIVE, 1);
    set(socket, IPPROTO_TCP, TCP_KEEPIDLE, kIdleSeconds);
    set(socket, IPPROTO_TCP, TCP_KEEPINTVL, kProbeSeconds);
    set(socket, IPPROTO_TCP, TCP_KEEPCNT, kProbes);
    set(socket, IPPROTO_TCP, TCP_USER_TIMEOUT, static_cast<int>(std::chrono::milliseconds{kSilenceLimit}.count()));
}

/// Connects to one address; gives the system's number of what went wrong, or 0.
int connectTo(const HostAddress& address, const WakeEvent& stopped, std::chrono::nanoseconds atMost, Descriptor& socket)
{
    socket = Descriptor{::socket(address.family(), SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, IPPROTO_TCP)};
    if (!socket.isOpen())
        return errno;
    setOptions(socket);
    if (::connect(socket.number(), address.get(), address.length) == 0)
        return 0;
    if (errno != EINPROGRESS && errno != EINTR)
        return errno;
    const Readiness ready = waitUntilReady(socket.number(), POLLOUT, stopped, atMost);
    if (ready.woken)
        return ECANCELED;
    if (ready.events == 0)
        return ETIMEDOUT;
    int error = 0;
    socklen_t size = sizeof error;
    return ::getsockopt(socket.number(), SOL_SOCKET, SO_ERROR, &error, &size) == 0 ? error : errno;
}

}  // namespace

Result<std::unique_ptr<Transport>> openTcpLink(const std::string& host, std::uint16_t port, const Clock& clock,
                                               std::chrono::nanoseconds deadline, const std::stop_token& stop,
                                               bool wasThere)
{
    const std::string name = hostText(host, port);
    const auto addresses = resolveHost(host, port, clock, deadline, stop);
    if (!addresses)
        return fail(addresses.error().code, name + ": " + addresses.error().message);
    const WakeEvent stopped;
    if (!stopped.isOpen())
        return fail(ErrorCode::NoDevice, name + ": the system has no files left; end other programs and try again");
    const std::stop_callback raise{stop, [&] { stopped.raise(); }};
    std::string trouble;
    for (std::size_t i = 0; i < addresses->size(); ++i) {
        // An address that is silent must not take the time of the next: "localhost" has two.
        const auto others = static_cast<std::chrono::nanoseconds::rep>(addresses->size() - i);
        Descriptor socket;
        const int error = connectTo((*addresses)[i], stopped, (deadline - clock.now()) / others, socket);
        if (stop.stop_requested())
            return fail(ErrorCode::Interrupted, name + ": stopped while it was connected");
        if (error == 0)
            return DescriptorLink::open(std::move(socket), name, tcpEndText, clock);
        trouble = connectTroubleText(error, (*addresses)[i], ownNetworks(), wasThere);
    }
    return fail(ErrorCode::NoDevice, name + ": " + trouble);
}

}  // namespace planewright
