// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <optional>
#include <stop_token>

#include "app/session/loops/channel.h"
#include "app/session/loops/scan_item.h"
#include "core/types/error.h"
#include "devices/scan_source.h"

namespace planewright {

/// Hears what happens to the source, on the loop's thread.
struct AcquisitionEvents {
    std::function<void()> onBegun;              ///< it stands where the scan begins: the next is a slice
    std::function<void(const Error&)> onFault;  ///< it has failed; the loop waits for retry() or giveUp()
    std::function<void(ScanOutcome)> onEnded;   ///< there will be no more slices
    /// A link has failed, and after a while the loop tries again by itself. May be empty.
    std::function<void(const Error&, std::chrono::milliseconds wait)> onRecovering = {};
    /// What went wrong with devices meanwhile, oldest first: what has cost nothing, and what led to a fault, right
    /// before that is told: `fault` is that one then, else null. At most once a second while slices come. May be empty.
    std::function<void(const std::vector<FaultRecord>&, const Error* fault)> onRecords = {};
};

/// How often a scan goes on by itself after a link to a device has failed, 0.5, 1, 2, 2 … s later. What needs a person
/// is never tried again unasked.
struct AutomaticRecovery {
    int mostInARow = 0;  ///< without a slice between them
    int mostInAll = 0;
};

/// Takes slices from a source, as a recording will give them back, and hands them on. It waits for nobody but the
/// source.
class AcquisitionLoop {
public:
    AcquisitionLoop(ScanSource& source, Channel<AcquiredItem>& out, const Clock& clock, AcquisitionEvents events,
                    AutomaticRecovery recovery = {});

    /// One scan, to its last slice or until finish(); at the end what moves comes to rest, and the outcome is handed
    /// on: of a scanner it is complete only with every slice of its plan.
    void run();

    /// Ends the scan with what there is: what has been taken is worked through.
    void finish() { stop_.request_stop(); }

    /// After a fault: tries to go on, at once where it would by itself later, or ends the scan.
    void retry();
    void giveUp();

    /// Slices a second over the last second or so; 0 before the second slice.
    double slicesPerSecond() const;
    int slices() const { return slices_; }
    /// Steps that were passed over; of a scanner also those before the first slice and after the last.
    int lost() const { return lost_; }

private:
    enum class Verdict { Retry, GiveUp };

    ScanOutcome takeSlices();
    Result<bool> takeSlice(bool& begun);
    ScanOutcome outcomeOfTheEnd();
    void tellRecords(const Error* fault = nullptr);
    void tellRecordsNowAndThen();
    Verdict judge(const Error& error);
    std::optional<std::chrono::milliseconds> waitBeforeRetry(const Error& error);
    void forgetVerdict();
    std::optional<Verdict> waitForVerdict(std::optional<std::chrono::nanoseconds> until);
    void handOn(ScanSlice slice);

    ScanSource& source_;
    Channel<AcquiredItem>& out_;
    const Clock& clock_;
    AcquisitionEvents events_;
    const AutomaticRecovery recovery_;
    int triesInARow_ = 0;
    int tries_ = 0;
    std::stop_source stop_;
    mutable std::mutex mutex_;
    std::condition_variable_any judged_;
    std::optional<Verdict> verdict_;
    std::deque<std::chrono::nanoseconds> times_;  ///< of the last slices
    std::optional<int> lastStep_;
    std::chrono::nanoseconds toldAt_{0};  ///< records of faults
    std::atomic<int> slices_{0};
    std::atomic<int> lost_{0};
};

}  // namespace planewright
