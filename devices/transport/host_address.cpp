// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/transport/host_address.h"

#include <algorithm>
#include <condition_variable>
#include <cstring>
#include <memory>
#include <mutex>
#include <netdb.h>
#include <optional>
#include <system_error>
#include <thread>

namespace planewright {

namespace {

struct Lookup {
    int problem = 0;  ///< of getaddrinfo(); 0: none
    std::vector<HostAddress> addresses;
};

Lookup lookUp(const std::string& host, std::uint16_t port, int flags)
{
    addrinfo hints{};
    hints.ai_family = AF_UNSPEC;
    hints.ai_socktype = SOCK_STREAM;
    hints.ai_flags = flags | AI_NUMERICSERV;
    addrinfo* found = nullptr;
    Lookup lookup;
    lookup.problem = ::getaddrinfo(host.c_str(), std::to_string(port).c_str(), &hints, &found);
    if (lookup.problem != 0)
        return lookup;
    for (const addrinfo* entry = found; entry != nullptr; entry = entry->ai_next) {
        HostAddress address;
        address.length = std::min(entry->ai_addrlen, static_cast<socklen_t>(sizeof address.bytes));
        std::memcpy(&address.bytes, entry->ai_addr, address.length);
        lookup.addresses.push_back(address);
    }
    ::freeaddrinfo(found);
    return lookup;
}

/// Where a lookup leaves what it found. Whoever wanted it may have gone before.
struct Answer {
    std::mutex mutex;
    std::condition_variable_any there;
    std::optional<Lookup> lookup;
};

Result<std::vector<HostAddress>> addressesOf(Lookup lookup)
{
    if (lookup.problem == EAI_AGAIN)
        return fail(ErrorCode::NoDevice, "the name cannot be looked up now; give the number, such as 192.168.0.10");
    if (lookup.problem != 0 || lookup.addresses.empty())
        return fail(ErrorCode::NoDevice,
                    "there is no host of this name; check how it is written, or give its number, such as 192.168.0.10");
    return std::move(lookup.addresses);
}

}  // namespace

Result<std::vector<HostAddress>> resolveHost(const std::string& host, std::uint16_t port, const Clock& clock,
                                             std::chrono::nanoseconds deadline, const std::stop_token& stop)
{
    if (Lookup number = lookUp(host, port, AI_NUMERICHOST); number.problem == 0)
        return addressesOf(std::move(number));
    const auto answer = std::make_shared<Answer>();
    try {
        std::thread{[answer, host, port] {
            Lookup lookup = lookUp(host, port, 0);
            const std::scoped_lock lock(answer->mutex);
            answer->lookup = std::move(lookup);
            answer->there.notify_all();
        }}.detach();
    } catch (const std::system_error&) {
        return fail(ErrorCode::NoDevice, "the system has no threads left; end other programs and try again");
    }
    std::unique_lock lock(answer->mutex);
    while (!answer->lookup) {
        if (stop.stop_requested())
            return fail(ErrorCode::Interrupted, "stopped while its name was looked up");
        if (clock.now() >= deadline)
            return fail(ErrorCode::NoDevice, "its name was not found in time; give the number, such as 192.168.0.10");
        clock.wait(lock, answer->there, stop, deadline);
    }
    return addressesOf(std::move(*answer->lookup));
}

std::string hostText(const std::string& host, std::uint16_t port)
{
    const bool isNumberOfVersion6 = host.find(':') != std::string::npos;
    return (isNumberOfVersion6 ? "[" + host + "]" : host) + ":" + std::to_string(port);
}

}  // namespace planewright
