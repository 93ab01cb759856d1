// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/dynamixel/bus_turns.h"

namespace planewright {

void BusTurns::begin(bool isUrgent)
{
    std::unique_lock lock(mutex_);
    if (isUrgent)
        ++urgent_;
    freed_.wait(lock, [&] { return !isBusy_ && (isUrgent || urgent_ == 0); });
    if (isUrgent)
        --urgent_;
    isBusy_ = true;
}

void BusTurns::end()
{
    const std::scoped_lock lock(mutex_);
    isBusy_ = false;
    freed_.notify_all();
}

}  // namespace planewright
