// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/emulated/emulated_laser_faults.h"

#include <algorithm>
#include <array>

namespace planewright {

namespace {

using Strikes = LaserFaultKind::Strikes;

constexpr auto kLaserFaults = std::to_array<LaserFaultKind>({
    {"laser-blind", "no beam comes back from then on, as with a covered window", Strikes::Scan},
    {"laser-boot", "the laser starts anew and is silent for three seconds; at step 0 it is just starting",
     Strikes::Scan},
    {"laser-byte-loss", "one byte of a scan is lost", Strikes::Bytes},
    {"laser-corrupt", "one bit of a scan's data is flipped", Strikes::Bytes},
    {"laser-count", "a scan has one beam too few, in good order otherwise", Strikes::Scan},
    {"laser-cut", "the rest of a scan is missing", Strikes::Bytes},
    {"laser-delay", "a scan comes 200 ms late, and those behind it wait", Strikes::Scan},
    {"laser-duplicate", "a scan comes twice", Strikes::Bytes},
    {"laser-garbage", "random bytes come before a scan", Strikes::Bytes},
    {"laser-interleave", "the answer to another request comes in the middle of a scan", Strikes::Bytes},
    {"laser-malfunction", "the laser reports a fault of its hardware that only a new start of its power cures",
     Strikes::Scan},
    {"laser-limits", "the laser sees ten degrees less on both sides from then on, and says so when it is asked",
     Strikes::Scan},
    {"laser-model", "the laser says from then on that it is of another model", Strikes::Scan},
    {"laser-prestream", "the laser streams already when it is connected", Strikes::Connection},
    {"laser-reset", "the laser's clock is set to zero", Strikes::Scan},
    {"laser-scip1", "the laser speaks SCIP 1.1 until it is asked for 2.0", Strikes::Connection},
    {"laser-silent", "scans stop until they are asked for anew", Strikes::Scan},
    {"laser-stuck-time", "the time of scans stands still until they are asked for anew", Strikes::Scan},
    {"laser-time-mode", "the laser is in time mode when it is connected", Strikes::Connection},
    {"laser-unplug", "the link is pulled out in the middle of a scan; at step 0 it was never there", Strikes::Scan},
    {"laser-wrap",
     "the laser's clock begins again at 0, as every 4.66 hours, three seconds and STEP turns after power-on",
     Strikes::Connection},
});

std::size_t anyOf(std::size_t count, Random& random)
{
    return count == 0 ? 0 : static_cast<std::size_t>(random.integer(0, static_cast<int>(count) - 1));
}

/// Where a scan's data begin: after echo, status and stamp. The end, where another fault has left less.
std::size_t dataOf(std::string_view bytes)
{
    std::size_t at = 0;
    for (int line = 0; line < 3; ++line)
        at = std::min(bytes.find('\n', at), bytes.size() - 1) + 1;
    return at;
}

void flipOneBit(std::string& bytes, Random& random)
{
    const std::size_t begin = dataOf(bytes);
    std::size_t at = begin + anyOf(bytes.size() - begin, random);
    while (at > 0 && (at == bytes.size() || bytes[at] == '\n'))
        --at;
    bytes[at] = static_cast<char>(static_cast<unsigned char>(bytes[at]) ^ (1U << anyOf(7, random)));
}

std::string garbage(Random& random)
{
    std::string bytes(1 + anyOf(400, random), '\0');
    std::generate(bytes.begin(), bytes.end(), [&] { return static_cast<char>(random.integer(0, 255)); });
    return bytes;
}

}  // namespace

std::span<const LaserFaultKind> laserFaultKinds()
{
    return kLaserFaults;
}

Result<void> checkLaserFault(const FaultAt& fault)
{
    std::string known;
    for (const LaserFaultKind& kind : kLaserFaults) {
        if (kind.name == fault.kind && fault.step >= 0)
            return {};
        if (kind.name == fault.kind)
            return fail(ErrorCode::Usage, fault.kind + "@" + std::to_string(fault.step) + ": steps begin at 0");
        known += (known.empty() ? "" : ", ") + std::string{kind.name};
    }
    return fail(ErrorCode::Usage, "there is no fault '" + fault.kind + "' of a laser; known: " + known);
}

std::string damageScan(std::string_view kind, std::string bytes, const std::string& reply, Random& random)
{
    if (kind == "laser-cut")
        bytes.resize(1 + anyOf(bytes.size() - 1, random));
    else if (kind == "laser-corrupt")
        flipOneBit(bytes, random);
    else if (kind == "laser-interleave")
        bytes.insert(dataOf(bytes) + anyOf(bytes.size() - dataOf(bytes), random), reply);
    else if (kind == "laser-garbage")
        bytes.insert(0, garbage(random));
    else if (kind == "laser-duplicate")
        bytes += std::string{bytes};
    else if (kind == "laser-byte-loss")
        bytes.erase(anyOf(bytes.size(), random), 1);
    return bytes;
}

}  // namespace planewright
