// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <chrono>
#include <functional>
#include <stop_token>
#include <string>
#include <string_view>

#include "core/types/error.h"
#include "devices/scip/scip_link.h"
#include "devices/scip/scip_status.h"

namespace planewright {

/// Told what a laser is waited for, a line at a time, while that takes long.
using ScipProgress = std::function<void(const std::string&)>;

/// For how long a laser that does not answer, or says "not now", is asked again: its motor may still be running up.
inline constexpr std::chrono::seconds kScipBootTime{20};

/// Tells how much longer it is waited for at most; nothing where that time is over.
void tellScipCountdown(const ScipLink& link, ScipLink::Time deadline, const ScipProgress& progress);

/// The error of a stop that came while a laser was spoken to.
tl::unexpected<Error> scipInterrupted(const ScipLink& link);

/// Asks as long as the answer is "not now" or none comes, up to kScipBootTime, with a countdown. Gives the first other
/// answer.
///
/// Errors (NoDevice): the time is over; DeviceLost: those of the transport; Interrupted: a stop.
Result<ScipReply> askScipPatiently(ScipLink& link, std::string_view request, ScipVersion version,
                                   const ScipProgress& progress, const std::stop_token& stop);

/// Resets a laser that says that it is faulty. Its clock is zero afterwards, and its laser off. Errors: those of the
/// transport.
Result<void> resetScip(ScipLink& link, const std::stop_token& stop);

}  // namespace planewright
