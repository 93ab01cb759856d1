// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/transport/tcp_trouble.h"

#include <algorithm>
#include <bit>
#include <cerrno>
#include <cstring>
#include <ifaddrs.h>
#include <net/if.h>
#include <optional>
#include <system_error>

namespace planewright {

namespace {

/// The number of an address of version 4; of no other.
std::optional<std::uint32_t> numberOf(const sockaddr* address)
{
    if (address == nullptr || address->sa_family != AF_INET)
        return std::nullopt;
    sockaddr_in version4{};
    std::memcpy(&version4, address, sizeof version4);
    return ntohl(version4.sin_addr.s_addr);
}

std::string numberText(std::uint32_t number)
{
    std::string text;
    for (const int shift : {24, 16, 8, 0})
        text += std::to_string((number >> shift) & 0xFF) + (shift > 0 ? "." : "");
    return text;
}

/// An address in the network of another: one that is likely to be free.
std::uint32_t neighbourOf(std::uint32_t number)
{
    constexpr std::uint32_t kLast = 0xFF;
    constexpr std::uint32_t kUsual = 100;
    return (number & ~kLast) | ((number & kLast) == kUsual ? kUsual + 1 : kUsual);
}

std::string networkText(std::uint32_t number, std::span<const OwnNetwork> networks)
{
    const auto holds = [&](const OwnNetwork& own) { return (own.address & own.mask) == (number & own.mask); };
    if (std::any_of(networks.begin(), networks.end(), holds))
        return "";
    std::string own;
    for (const OwnNetwork& network : networks)
        own +=
            (own.empty() ? "" : ", ") + numberText(network.address) + "/" + std::to_string(std::popcount(network.mask));
    return "; this computer is in another network (" + (own.empty() ? "it has no address" : own) +
           "): give its network card an address such as " + numberText(neighbourOf(number)) + "/24";
}

}  // namespace

std::vector<OwnNetwork> ownNetworks()
{
    std::vector<OwnNetwork> networks;
    ifaddrs* all = nullptr;
    if (::getifaddrs(&all) != 0)
        return networks;
    for (const ifaddrs* entry = all; entry != nullptr; entry = entry->ifa_next) {
        const auto address = numberOf(entry->ifa_addr);
        const auto mask = numberOf(entry->ifa_netmask);
        if (address && mask && (entry->ifa_flags & IFF_UP) != 0 && (entry->ifa_flags & IFF_LOOPBACK) == 0)
            networks.push_back({*address, *mask});
    }
    ::freeifaddrs(all);
    return networks;
}

std::string connectTroubleText(int error, const HostAddress& address, std::span<const OwnNetwork> networks,
                               bool wasThere)
{
    switch (error) {
        case ECONNREFUSED:
            if (wasThere)
                return "nothing answers there yet; it may still be starting: check its power and its cable";
            return "refused the connection: nothing listens at this port, or another program is connected already; "
                   "check the port, and end the other program: it serves one client at a time";
        case ECONNRESET:
            return tcpEndText(error, false);
        case EACCES:
        case EPERM:
            return "the system does not allow this connection; check the address and the firewall";
        case ETIMEDOUT:
        case ENETUNREACH:
        case EHOSTUNREACH:
        case EHOSTDOWN:
        case ENETDOWN:
        case EADDRNOTAVAIL: {
            const auto number = numberOf(address.get());
            return std::string{error == ETIMEDOUT ? "does not answer" : "cannot be reached from here"} +
                   "; check its power, its cable and the address" + (number ? networkText(*number, networks) : "");
        }
        default:
            return "cannot be connected (" + std::generic_category().message(error) + "); check the address";
    }
}

std::string tcpEndText(int error, bool anythingCame)
{
    const bool wasClosed = error == 0 || error == ECONNRESET || error == EPIPE;
    if (wasClosed && !anythingCame)
        return "closed the connection before it said anything; end the other program that is connected to it: it "
               "serves one client at a time";
    if (error == 0)
        return "closed the connection; check its power, then connect it again";
    if (wasClosed)
        return "broke off the connection, as after a restart; connect it again";
    return "does not answer any more; check its power and its cable, then connect it again";
}

}  // namespace planewright
