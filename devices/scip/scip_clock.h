// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <chrono>
#include <cstdint>
#include <deque>
#include <optional>

#include "devices/scip/scip_stamps.h"

namespace planewright {

/// Tells when, by the host's clock, a laser measured what it stamped with its own.
///
/// Two things are known. In time mode the laser was asked for its time: it read its clock between the question and the
/// answer, and the quickest answer says it best. And no scan arrives before its last beam was measured: the least
/// delay between the two, over some seconds, is that of the way, and follows the clocks as they drift apart. From both
/// together comes how long the way takes at least; without time mode it counts as nothing, and scans seem to be later
/// than they are by it, some milliseconds. The drift within the seconds that are looked at is an error too: a tenth of
/// a millisecond for every ten millionths.
class ScipClock {
public:
    using Time = std::chrono::nanoseconds;

    /// Slowest answer that tells how the clocks stand: half of it is what nobody knows.
    static constexpr std::chrono::milliseconds kSlowestAnswer{20};
    /// Arrivals that count: those of the last ten seconds.
    static constexpr std::chrono::seconds kWindow{10};
    /// Arrivals after which the least delay is taken for that of the way.
    static constexpr int kSettled = 40;

    /// Arrivals without answers after which the clocks are known: whatever has held up the first scans, so much silence
    /// is taken for a stream that has ended.
    static constexpr int kKnown = 16;

    /// Forgets what a scan before has told of the two clocks, but not how long the way takes.
    void restart();

    /// Scans begin anew after a pause, in which the laser may have started anew itself: the next one comes promptly.
    void expectPromptScan() { isPrompt_ = true; }

    /// The laser's answer in time mode, and when it was asked for and had come, by the host.
    void addAnswer(std::uint32_t stamp, Time asked, Time answered);

    /// A scan as it was stamped and had come, complete.
    struct Scan {
        Time start{0};  ///< of step 0, by the host
        bool isNewEpoch = false;
        bool isKnown = true;            ///< how the clocks stand to each other
        bool isLate = false;            ///< it came later than `period` after it should have
        bool isBehind = false;          ///< it came nearly as late: its stamp may be that of the scan before
        int repeats = 0;                ///< how many scans before it had the same stamp
        std::int64_t milliseconds = 0;  ///< by the laser, from the zero of its epoch
    };
    /// `end`: from step 0 to the last beam that was measured. A repeated stamp tells nothing of the clocks.
    Scan addScan(std::uint32_t stamp, Time arrived, Time end, Time period);

private:
    struct Delay {
        Time arrived;
        Time delay;
    };
    void addArrival(Time arrived, Time delay);
    Time offset() const;

    ScipStamps stamps_;
    int epoch_ = 0;
    bool isPrompt_ = false;
    std::deque<Delay> least_;    ///< of the window: each is less than all that came after it
    int arrivals_ = 0;           ///< since the clocks were last compared anew
    int behind_ = 0;             ///< scans that came late, one behind the other
    std::optional<Time> asked_;  ///< host minus laser, by the quickest answer in time mode
    Time quickest_{0};           ///< how long that took
    bool isDoubtful_ = false;    ///< what is known of the clocks may be off by what the link is late
    std::optional<Time> way_;    ///< the least time of the way of a scan
};

}  // namespace planewright
