// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/types/error.h"
#include "devices/laser.h"
#include "devices/scip/scip_event.h"

namespace planewright {

/// The value of a field of a VV, PP or II reply, without blanks around it; empty where there is none of that name.
std::optional<std::string> scipField(const ScipReply& reply, std::string_view key);

/// Who it is, by its VV reply; fields that are not there stay empty. `model` comes with readScipLimits().
LaserIdentity readScipIdentity(const ScipReply& reply);

/// What it can see, by its PP reply.
///
/// Errors (NoDevice) begin with the name of the link: a key is missing, is no number, or has a value that no laser can
/// have.
Result<LaserLimits> readScipLimits(const ScipReply& reply, const std::string& name);

/// What a laser says of itself in an II reply.
struct ScipState {
    std::optional<std::uint32_t> clock;  ///< [ms], 24 bits
    std::string condition;               ///< STAT, in its own words
    bool isFaulty = false;               ///< these tell of a fault
    bool isHealthy = false;              ///< these are known to mean that nothing is wrong
};

/// Reads an II reply. TIME has six hexadecimal digits on some lasers and four characters of the alphabet on others.
ScipState readScipState(const ScipReply& reply);

}  // namespace planewright
