// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/transport/ftdi_wire.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <string>

namespace planewright {

namespace {

constexpr std::size_t kStatusBytes = 2;
constexpr std::uint8_t kOverrun = 0x02;          // of the second, which is the line status of a 16550
constexpr std::uint32_t kMostEighths = 0x1FFFF;  // 14 bits of whole divisors and 3 of eighths
constexpr std::uint32_t kFastClock = 0x20000;    // bit 17: the FT232H's 12 MHz instead of its 3 MHz
constexpr std::array<std::uint32_t, 8> kEighths{0, 3, 2, 4, 1, 5, 6, 7};  // how the chips number eighths

/// Whole part in bits 0 to 13, eighths in 14 to 16. The chips take 0 for a divisor of 1 and 1 for one of 1.5.
std::uint32_t encode(std::uint32_t eighths)
{
    if (eighths == 8)
        return 0;
    if (eighths == 12)
        return 1;
    return eighths >> 3 | kEighths[eighths & 7] << 14;
}

/// The nearest divisor that a chip has, in eighths: between 1 and 2 there is only 1.5.
std::uint32_t nearestEighths(double wanted)
{
    const double most = kMostEighths;
    if (wanted < 16.0)
        return wanted < 10.0 ? 8 : wanted < 14.0 ? 12 : 16;
    return static_cast<std::uint32_t>(std::lround(std::min(wanted, most)));
}

}  // namespace

Result<FtdiDivisor> ftdiDivisor(FtdiChip chip, int rate)
{
    const double clock = chip == FtdiChip::Ft232h ? 12.0e6 : 3.0e6;
    const std::uint32_t eighths = nearestEighths(8.0 * clock / std::max(rate, 1));
    const double real = 8.0 * clock / eighths;
    if (rate < 1 || std::abs(real - rate) > 0.02 * rate)
        return fail(ErrorCode::Usage, "the adapter has no baud rate " + std::to_string(rate) +
                                          "; choose one of its servo, such as 57142 or 1000000");
    const std::uint32_t code = encode(eighths) | (chip == FtdiChip::Ft232h ? kFastClock : 0);
    const std::uint32_t high = code >> 16;
    // The FT232H has the channel's number in the low byte, as its sisters with several channels; it has only number 0.
    return FtdiDivisor{.value = static_cast<std::uint16_t>(code & 0xFFFF),
                       .index = static_cast<std::uint16_t>(chip == FtdiChip::Ft232h ? high << 8 : high),
                       .rate = real};
}

FtdiPayload stripFtdiStatus(std::span<std::uint8_t> transfer, std::size_t packetSize)
{
    assert(packetSize > kStatusBytes);
    FtdiPayload payload;
    for (std::size_t begin = 0; begin < transfer.size(); begin += packetSize) {
        const auto packet = transfer.subspan(begin, std::min(packetSize, transfer.size() - begin));
        if (packet.size() < kStatusBytes)
            break;
        payload.overruns += (packet[1] & kOverrun) != 0 ? 1 : 0;
        const auto bytes = packet.subspan(kStatusBytes);
        std::copy(bytes.begin(), bytes.end(), transfer.begin() + static_cast<std::ptrdiff_t>(payload.count));
        payload.count += bytes.size();
    }
    return payload;
}

}  // namespace planewright
