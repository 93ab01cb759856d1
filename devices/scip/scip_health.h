// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <chrono>
#include <deque>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

#include "devices/laser.h"

namespace planewright {

/// Counts what becomes of a laser's scans; any thread may read it while another counts.
class ScipHealth {
public:
    using Time = std::chrono::nanoseconds;

    /// All counters to zero; the log stays.
    void restart();

    void countGood(Time arrived, bool isLate);
    void countCorrupt();
    void countLost(std::uint64_t scans);

    /// A fault for the log, with the bytes that told of it.
    void log(Time at, std::string_view code, std::string text, std::string_view bytes = {});
    std::vector<FaultRecord> takeLog() { return log_.take(); }

    /// What is wrong now; empty: nothing.
    void setTrouble(std::string trouble);

    LinkHealth read(Time now) const;

private:
    mutable std::mutex mutex_;
    LinkHealth counters_;
    std::deque<Time> recent_;  ///< arrivals of the last second before the last of them
    FaultLog log_;
};

}  // namespace planewright
