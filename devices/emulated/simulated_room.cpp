// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/emulated/simulated_room.h"

#include <utility>

#include "core/simulation/nodding_scanner.h"

namespace planewright {

SimulatedRoom::SimulatedRoom(Scene scene, const SimulatedScanner& scanner, const Clock& clock)
    : scene_(std::move(scene)),
      scanner_(scanner),
      description_(describeScan(scanner.settings)),
      pacer_(clock, isReplaySpeed(scanner.speed) ? scanner.speed : 1.0)
{
}

Result<void> SimulatedRoom::begin(const std::stop_token& /*stop*/)
{
    next_ = 0;
    pacer_.restart();
    return {};
}

Result<std::optional<ScanSlice>> SimulatedRoom::next(const std::stop_token& stop)
{
    if (next_ >= scanner_.settings.slices)
        return std::nullopt;
    SimulatedSlice simulated = simulateSlice(scene_, scanner_.settings, scanner_.noise, scanner_.seed, next_);
    if (!pacer_.wait(simulated.slice.time, stop))
        return std::nullopt;
    ++next_;
    return std::move(simulated.slice);
}

Result<void> SimulatedRoom::pause()
{
    pacer_.pause();
    return {};
}

Result<void> SimulatedRoom::resume()
{
    pacer_.resume();
    return {};
}

/// Its head stands still while it is paused.
Result<void> SimulatedRoom::stopMotion()
{
    return pause();
}

}  // namespace planewright
