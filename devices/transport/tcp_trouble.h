// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "devices/transport/host_address.h"

namespace planewright {

/// An address of this computer and the size of its network, both as numbers of version 4.
struct OwnNetwork {
    std::uint32_t address = 0;
    std::uint32_t mask = 0;
};

/// The networks that this computer is in now, that with itself left out.
std::vector<OwnNetwork> ownNetworks();

/// Why a connection to an address did not come about, and what to do; without the name in front. `error` is the
/// system's number. Where the address is in none of the networks given, the text says so: it is the usual reason why a
/// laser that has just been bought does not answer. `wasThere`: something has answered at this address before.
std::string connectTroubleText(int error, const HostAddress& address, std::span<const OwnNetwork> networks,
                               bool wasThere = false);

/// Why a connection is over: a LinkEndText.
std::string tcpEndText(int error, bool anythingCame);

}  // namespace planewright
