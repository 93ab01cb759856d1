// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/types/error.h"

namespace planewright {

/// Bytes that leave a device at a moment.
struct EmulatedOutput {
    std::chrono::nanoseconds at{0};  ///< when the last of them has left
    std::vector<std::uint8_t> bytes;
};

/// A device that speaks its bytes, as a function of time: it has no thread and no clock, its caller tells it the
/// moment. Moments never go back.
class EmulatedDevice {
public:
    virtual ~EmulatedDevice() = default;

    /// Bytes that have come at a moment.
    virtual void receive(std::span<const std::uint8_t> bytes, std::chrono::nanoseconds now) = 0;

    /// What has left it up to a moment, in order; gives every byte once.
    virtual std::vector<EmulatedOutput> takeOutput(std::chrono::nanoseconds now) = 0;

    /// The next moment at which takeOutput() may give something if nothing is received before; empty: never. May be
    /// early, never late.
    virtual std::optional<std::chrono::nanoseconds> nextOutput() const = 0;

    /// False where the link has been pulled out by a moment.
    virtual bool isConnected(std::chrono::nanoseconds now) = 0;
};

/// Makes something go wrong from a moment on: KIND@STEP of the command line.
struct FaultAt {
    std::string kind;
    int step = 0;  ///< turns of the laser's mirror (25 ms) since it first streamed; 0 = from the beginning
};

}  // namespace planewright
