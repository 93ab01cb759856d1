// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <variant>
#include <vector>

#include "app/session/loops/channel.h"
#include "app/session/loops/scan_item.h"
#include "app/session/loops/slice_recorder.h"

namespace planewright {

/// Hears how writing goes, on the loop's thread.
struct RecordingEvents {
    std::function<void(const Error&)> onTrouble;        ///< writing fails; what comes is held in memory
    std::function<void()> onRecovered;                  ///< all that was held is on the disk
    std::function<void(const Result<void>&)> onClosed;  ///< the recording is closed, or given up with an error
};

/// How writing goes.
struct RecordingStatus {
    std::uint64_t bytes = 0;                 ///< on the disk
    std::optional<std::uint64_t> freeBytes;  ///< what there is room for
    std::size_t notOnDisk = 0;               ///< slices and notes that are held in memory
};

/// Puts all that comes on the disk before it hands it on, so that no fault further on can lose it. While writing fails
/// it holds what comes in memory, hands it on all the same, and tries again every second. At the end of the scan it
/// tries kLastTries times; afterwards what is held is given up, and onClosed says so.
class RecordingLoop {
public:
    static constexpr std::chrono::seconds kRetryAfter{1};
    static constexpr int kLastTries = 10;

    /// Without a recorder all is handed on as it comes. The first parameters are those of the beginning.
    RecordingLoop(std::unique_ptr<SliceRecorder> recorder, ScanDescription description,
                  std::optional<int> plannedSlices, const std::vector<ParametersFrom>& parameters,
                  Channel<AcquiredItem>& in, Channel<ExtractionItem>& out, const Clock& clock, RecordingEvents events);

    /// One scan, until its outcome comes; then closes the recording.
    void run();

    /// The program has no time left: a failure from now on is the last.
    void hurry();

    RecordingStatus status() const;
    bool isOn() const { return recorder_ != nullptr; }

private:
    using Held = std::variant<SharedSlice, ParametersFrom, ScanEvent>;

    void take(AcquiredItem item);
    void hold(Held item);
    void writeHeld();
    void tryToWriteHeld();
    void close();
    Result<void> writeNext();
    void lookAtDisk();
    Result<void> guarded(const std::function<Result<void>()>& write) const;

    std::unique_ptr<SliceRecorder> recorder_;
    ScanDescription description_;
    std::optional<int> plannedSlices_;
    Channel<AcquiredItem>& in_;
    Channel<ExtractionItem>& out_;
    const Clock& clock_;
    RecordingEvents events_;
    std::deque<Held> held_;
    bool begun_ = false;
    std::optional<std::chrono::nanoseconds> retryAt_;  ///< writing fails
    std::optional<Error> trouble_;
    std::optional<ScanOutcome> outcome_;
    int lastStep_ = -1;
    std::chrono::nanoseconds lookedAtDisk_{std::chrono::nanoseconds::min()};
    std::atomic<bool> hurries_{false};
    mutable std::mutex mutex_;
    std::condition_variable_any hurried_;
    RecordingStatus status_;
};

}  // namespace planewright
