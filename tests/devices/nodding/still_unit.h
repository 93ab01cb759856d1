// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "core/types/angle.h"
#include "devices/tilt_unit.h"

namespace planewright {

/// A tilt unit that only says what it can do.
class StillUnit : public TiltUnit {
public:
    Result<void> connect(const std::stop_token& /*stop*/) override { return {}; }
    std::string identity() const override { return "still unit"; }
    double resolution() const override { return degrees(0.25); }
    double lowest() const override { return degrees(0.0); }
    double highest() const override { return degrees(180.0); }
    double fastest() const override { return degrees(100.0); }
    Result<void> arm(const std::stop_token& /*stop*/) override { return {}; }
    Result<void> moveTo(double /*pitch*/, double /*speed*/) override { return {}; }
    double nearestPitch(double pitch) const override { return pitch; }
    Result<std::optional<TiltSample>> sample(std::chrono::nanoseconds /*deadline*/,
                                             const std::stop_token& /*stop*/) override
    {
        return std::nullopt;
    }
    Result<void> hold() override { return {}; }
    LinkHealth health() const override { return {}; }
    MotorState motor() const override { return {}; }
};

/// What a UTM-30LX says of itself.
inline LaserLimits utm30lx()
{
    return {0.023, 60.0, 1440, 0, 1080, 540, std::chrono::milliseconds{25}};
}

}  // namespace planewright
