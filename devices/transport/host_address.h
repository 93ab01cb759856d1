// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <chrono>
#include <cstdint>
#include <netinet/in.h>
#include <stop_token>
#include <string>
#include <sys/socket.h>
#include <vector>

#include "core/types/error.h"
#include "devices/clock.h"

namespace planewright {

/// An address to connect to or to listen at.
struct HostAddress {
    sockaddr_storage bytes{};
    socklen_t length = 0;

    int family() const { return bytes.ss_family; }
    const sockaddr* get() const { return reinterpret_cast<const sockaddr*>(&bytes); }
};

/// The addresses of a host, best first: a number, or a name that is looked up. Ports are from 0 to 65535.
///
/// Names may take long where a network is set up wrongly, and the system cannot be told to stop: the wait ends all the
/// same at the deadline of the clock or with a stop. Errors: NoDevice, without the host's name in front; Interrupted.
Result<std::vector<HostAddress>> resolveHost(const std::string& host, std::uint16_t port, const Clock& clock,
                                             std::chrono::nanoseconds deadline, const std::stop_token& stop);

/// "192.168.0.10:10940", "[fe80::1]:10940".
std::string hostText(const std::string& host, std::uint16_t port);

}  // namespace planewright
