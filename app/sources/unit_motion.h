// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <stop_token>
#include <string>

#include "core/types/error.h"
#include "devices/clock.h"
#include "devices/tilt_unit.h"

namespace planewright {

/// Moves a tilt unit outside of a scan: for a test of it, or to bring it home.
///
/// One thread calls it. Whoever asks for the stop holds the unit at once, within one round trip and in his own thread;
/// nothing moves afterwards. Whatever goes wrong holds the unit, and with the end of this it comes to rest.
class UnitMotion {
public:
    /// Takes over a unit that is connected; nothing moves yet.
    UnitMotion(std::unique_ptr<TiltUnit> unit, const Clock& clock, std::stop_token stop);
    ~UnitMotion();
    UnitMotion(const UnitMotion&) = delete;
    UnitMotion& operator=(const UnitMotion&) = delete;

    const TiltUnit& unit() const { return *unit_; }

    /// Allows motion. Errors: those of the unit; Interrupted: a stop.
    Result<void> arm();

    /// Where it is now, φ [rad]. Errors: those of the unit; DeviceLost: it tells no angle; Interrupted: a stop.
    Result<double> position();

    /// Goes to φ [rad] at a speed [rad/s], and comes back when it has arrived. Errors: those of the unit; DeviceLost:
    /// it did not get there in three times the time that it should take, with where it is; Interrupted: a stop.
    Result<void> moveTo(double pitch, double speed);

    /// Allows motion and goes home: to level, or as near as it may, slowly. It comes to rest there and is held; gives
    /// where it is then [rad]. Errors: those of arm() and moveTo().
    Result<double> goHome();

    /// Comes to rest in order, and stays there.
    Result<void> rest();

private:
    Result<void> hold();
    Result<TiltSample> sample(std::chrono::nanoseconds until);
    Result<void> travel(double pitch, double speed, const std::function<Result<void>()>& begin);
    Result<void> travelUnheld(double pitch, double speed, const std::function<Result<void>()>& begin);
    tl::unexpected<Error> stopped() const;

    std::unique_ptr<TiltUnit> unit_;
    const Clock& clock_;
    std::stop_token stop_;
    std::atomic<bool> mayMove_{false};
    std::stop_callback<std::function<void()>> onStop_;  ///< last: the unit is there as long as it may be called
};

}  // namespace planewright
