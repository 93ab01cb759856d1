// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <stop_token>
#include <string>

#include "core/types/error.h"
#include "devices/clock.h"
#include "devices/transport/transport.h"

namespace planewright {

/// How long a host may take to answer at all.
inline constexpr std::chrono::seconds kConnectTimeout{3};

/// Connects over TCP: to a laser with a network plug, a serial server, or an emulated device. `host` is a name or a
/// number of version 4 or 6, without brackets.
///
/// Bytes are sent at once. A host that is silent is asked by the system itself whether it is still there, so that a
/// cable that was pulled ends the link within kSilenceLimit. Bytes that were given to write() and are not acknowledged
/// for as long end it, too.
///
/// Errors, with what to do: NoDevice where there is no such host or route, it does not answer before the clock's
/// deadline, or it refuses; Interrupted for a stop. `wasThere`: this program has been connected to it before.
Result<std::unique_ptr<Transport>> openTcpLink(const std::string& host, std::uint16_t port, const Clock& clock,
                                               std::chrono::nanoseconds deadline, const std::stop_token& stop,
                                               bool wasThere = false);

/// How long a connection may be without any sign of the other end.
inline constexpr std::chrono::seconds kSilenceLimit{5};

}  // namespace planewright
