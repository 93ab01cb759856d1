// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "core/types/error.h"

namespace planewright {

/// The clocks of FTDI's chips differ.
enum class FtdiChip {
    Ft232r,  ///< 3 MHz
    Ft232h,  ///< 12 MHz
};

/// What the request for a baud rate carries.
struct FtdiDivisor {
    std::uint16_t value = 0;
    std::uint16_t index = 0;
    double rate = 0.0;  ///< what it really gives [1/s]
};

/// The divisor for a baud rate [1/s]: whole and eighths of the clock over the rate, to the nearest (FTDI's AN 120).
/// Errors (Usage): the chip has none within 2 %, which is what a serial line bears.
Result<FtdiDivisor> ftdiDivisor(FtdiChip chip, int rate);

/// What is left of a transfer's bytes without the two of status that every packet begins with.
struct FtdiPayload {
    std::size_t count = 0;     ///< bytes, moved to the front
    std::size_t overruns = 0;  ///< packets before which the chip has lost bytes
};
FtdiPayload stripFtdiStatus(std::span<std::uint8_t> transfer, std::size_t packetSize);

}  // namespace planewright
