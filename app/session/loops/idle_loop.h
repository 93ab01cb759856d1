// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <stop_token>
#include <vector>

#include "core/types/error.h"
#include "devices/clock.h"
#include "devices/scan_source.h"

namespace planewright {

/// Hears what happens between scans, on the loop's thread.
struct IdleEvents {
    /// The head is at home, at an angle [rad] where there is one; or why it is not.
    std::function<void(const Result<std::optional<double>>&)> onHome;
    /// What went wrong with devices, oldest first.
    std::function<void(const std::vector<FaultRecord>&)> onRecords;
};

/// Looks after a scanner's devices twice a second while no scan runs, and brings its head home when it is asked to.
class IdleLoop {
public:
    IdleLoop(ScanSource& source, const Clock& clock, IdleEvents events);

    /// Until finish(), after which it ends soon: a device is waited for until it answers, a tenth of a second or so.
    void run();

    // Any thread.

    /// Once, as soon as what is done now is done; onHome tells how that went.
    void goHome();
    void finish();

private:
    bool takeWish();
    void lookAfter();

    ScanSource& source_;
    const Clock& clock_;
    IdleEvents events_;
    std::stop_source stop_;
    std::mutex mutex_;
    std::condition_variable_any asked_;
    bool goesHome_ = false;
};

}  // namespace planewright
