// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

// What any thread may ask of a scanner while another one scans.

#include <utility>

#include "devices/nodding/nodding_source.h"

namespace planewright {

Result<void> NoddingSource::pause()
{
    const std::scoped_lock lock{mutex_};
    paused_ = true;
    ++pauses_;
    asked_.notify_all();
    return {};
}

Result<void> NoddingSource::resume()
{
    const std::scoped_lock lock{mutex_};
    if (motionStopped_)
        return fail(ErrorCode::NeedsOperator, name() + ": motion was stopped; release it before the scan goes on");
    paused_ = false;
    asked_.notify_all();
    return {};
}

Result<void> NoddingSource::stopMotion()
{
    {
        const std::scoped_lock lock{mutex_};
        motionStopped_ = true;
        paused_ = true;
        ++pauses_;
        asked_.notify_all();
    }
    return devices_.hold();
}

void NoddingSource::release()
{
    const std::scoped_lock lock{mutex_};
    motionStopped_ = false;
    mayRecover_ = true;
}

NoddingHealth NoddingSource::deviceHealth() const
{
    return {devices_.laserHealth(), devices_.tiltHealth(), devices_.motor(), devices_.trouble(),
            Time{largestSkew_},     fitted_.pitchStep,     slicesLost_};
}

std::vector<HealthFact> NoddingSource::health() const
{
    return factsOf(deviceHealth());
}

bool NoddingSource::hasPermission() const
{
    const std::scoped_lock lock{mutex_};
    return mayRecover_;
}

bool NoddingSource::isHeld() const
{
    const std::scoped_lock lock{mutex_};
    return paused_ || motionStopped_;
}

bool NoddingSource::isMotionStopped() const
{
    const std::scoped_lock lock{mutex_};
    return motionStopped_;
}

/// True once after release().
bool NoddingSource::takePermission()
{
    const std::scoped_lock lock{mutex_};
    return std::exchange(mayRecover_, false);
}

int NoddingSource::pauses() const
{
    const std::scoped_lock lock{mutex_};
    return pauses_;
}

}  // namespace planewright
