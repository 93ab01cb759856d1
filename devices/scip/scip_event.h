// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "devices/scip/scip_request.h"

namespace planewright {

/// One line of a reply.
struct ScipLine {
    std::string text;       ///< without its sum; of "KEY:value;S" also without the semicolon
    bool isIntact = false;  ///< its sum is right
};

/// What a laser answers to a request, or reports by itself in the middle of a stream.
struct ScipReply {
    std::string echo;    ///< the request that it answers, with its tag
    std::string status;  ///< "00"; one character where the laser speaks SCIP 1.1
    std::vector<ScipLine> lines;
};

/// A further echo of a beam that has several.
struct ScipFurtherEcho {
    std::size_t value = 0;  ///< number of the value whose beam it is
    std::uint32_t range = 0;
    std::uint32_t intensity = 0;
};

/// One scan, whose every line had its right length and its right sum.
struct ScipFrame {
    std::string echo;                        ///< the request; of a counted one with the scans still to come
    ScipMeasurement measurement;             ///< the same in its parts
    std::uint32_t stamp = 0;                 ///< the laser's clock at step 0 [ms], 24 bits
    std::vector<std::uint32_t> ranges;       ///< as sent: [mm], or a code; exactly measurement.values() of them
    std::vector<std::uint32_t> intensities;  ///< as many, or none
    std::vector<ScipFurtherEcho> furtherEchoes;
};

/// What can be wrong with bytes that came.
enum class ScipDamageKind {
    UnknownEcho,   ///< the first line is no request of SCIP
    Status,        ///< the second line is no status, or not one that its reply can have
    Sum,           ///< a line whose sum is wrong
    Character,     ///< a character that no number has
    LineLength,    ///< a line of data that is too short or too long
    Count,         ///< not as much data as the request asks for
    Interrupted,   ///< another reply begins before the end
    LineTooLong,   ///< a line beyond every bound
    FrameTooLong,  ///< no end within every bound
};
inline constexpr std::size_t kScipDamageKinds = 9;

/// "laser-sum".
std::string_view codeOf(ScipDamageKind kind);
/// "a line with a wrong sum".
std::string describe(ScipDamageKind kind);

/// Bytes that were thrown away.
struct ScipDamage {
    ScipDamageKind kind{};
    std::string bytes;  ///< as they came; of a line that was too long only the beginning
};

using ScipEvent = std::variant<ScipReply, ScipFrame, ScipDamage>;

/// How often each kind of damage was met.
struct ScipDamageCounts {
    std::array<std::uint64_t, kScipDamageKinds> counts{};

    std::uint64_t of(ScipDamageKind kind) const { return counts[static_cast<std::size_t>(kind)]; }
    std::uint64_t total() const { return std::accumulate(counts.begin(), counts.end(), std::uint64_t{0}); }
};

}  // namespace planewright
