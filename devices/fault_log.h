// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <mutex>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace planewright {

/// One thing that went wrong with a device, as it was seen.
struct FaultRecord {
    std::chrono::nanoseconds at{0};  ///< host clock
    std::string code;                ///< kind of fault, for programs: "laser-sum"
    std::string text;                ///< one line, for people
    std::string bytes;               ///< what came, in hexadecimal: "4D 44 0A", "…" where it was longer; may be empty
};

/// A record in one line: what it was, its code and the bytes that came.
std::string recordText(const FaultRecord& record);

/// How often each kind of fault was seen.
using FaultCounts = std::map<std::string, std::uint64_t, std::less<>>;

/// The faults of a device of late, and the counts of all. Any thread.
class FaultLog {
public:
    static constexpr std::size_t kMostRecords = 20;
    static constexpr std::size_t kMostBytes = 64;

    void add(std::chrono::nanoseconds at, std::string_view code, std::string text,
             std::span<const std::uint8_t> bytes = {});

    /// What has come since it was last asked, oldest first, the last kMostRecords at most.
    std::vector<FaultRecord> take();

    FaultCounts counts() const;

    /// Counts from zero. Records that nobody has taken stay: they tell why a link was opened anew.
    void restartCounts();

private:
    mutable std::mutex mutex_;
    std::deque<FaultRecord> records_;
    FaultCounts counts_;
};

/// Text as bytes.
inline std::span<const std::uint8_t> textBytes(std::string_view text)
{
    return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

}  // namespace planewright
