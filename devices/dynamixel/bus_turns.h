// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <condition_variable>
#include <mutex>

namespace planewright {

/// Who may use a half duplex bus now: one at a time, and whoever is urgent before all others.
///
/// A plain mutex would let a thread that asks over and over again come back to it before the one that waits to stop
/// the motor.
class BusTurns {
public:
    /// A turn at the bus, from when it is made until it goes.
    class Turn {
    public:
        Turn(BusTurns& turns, bool isUrgent) : turns_(turns) { turns_.begin(isUrgent); }
        ~Turn() { turns_.end(); }
        Turn(const Turn&) = delete;
        Turn& operator=(const Turn&) = delete;

    private:
        BusTurns& turns_;
    };

private:
    void begin(bool isUrgent);
    void end();

    std::mutex mutex_;
    std::condition_variable freed_;
    bool isBusy_ = false;
    int urgent_ = 0;  ///< urgent ones that wait
};

}  // namespace planewright
