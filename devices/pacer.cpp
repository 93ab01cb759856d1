// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/pacer.h"

#include <algorithm>

namespace planewright {

bool isReplaySpeed(double speed)
{
    return speed == 0.0 || (speed >= kSlowestSpeed && speed <= kFastestSpeed);
}

Pacer::Pacer(const Clock& clock, double speed) : clock_(clock), speed_(speed) {}

void Pacer::restart()
{
    const std::lock_guard lock{mutex_};
    begun_ = false;
    paused_ = false;
    steps_ = 0;
    left_ = {};
}

bool Pacer::wait(std::chrono::microseconds scanTime, const std::stop_token& stop)
{
    std::unique_lock lock{mutex_};
    if (begun_)
        left_ = std::clamp<std::chrono::microseconds>(scanTime - scanTime_, std::chrono::seconds{0}, kLongestGap);
    else
        from_ = clock_.now();
    begun_ = true;
    scanTime_ = scanTime;
    while (!stop.stop_requested()) {
        const Nanoseconds now = clock_.now();
        if (paused_ && steps_ > 0) {
            --steps_;
            left_ = {};
            return true;
        }
        if (paused_) {
            clock_.wait(lock, steered_, stop, std::nullopt);
        } else if (speed_ == 0.0) {
            from_ = now;
            return true;
        } else if (const Nanoseconds moment = due(); now >= moment) {
            from_ = moment;
            return true;
        } else {
            clock_.wait(lock, steered_, stop, moment);
        }
    }
    return false;
}

void Pacer::pause()
{
    const std::lock_guard lock{mutex_};
    if (paused_)
        return;
    accountFor(clock_.now());
    paused_ = true;
    steered_.notify_all();
}

void Pacer::resume()
{
    const std::lock_guard lock{mutex_};
    if (!paused_)
        return;
    paused_ = false;
    steps_ = 0;
    from_ = clock_.now();
    steered_.notify_all();
}

Result<void> Pacer::step()
{
    const std::lock_guard lock{mutex_};
    if (!paused_)
        return fail(ErrorCode::Usage, "only a scan that is paused goes on by single steps; pause it first");
    ++steps_;
    steered_.notify_all();
    return {};
}

Result<void> Pacer::setSpeed(double speed)
{
    if (!isReplaySpeed(speed))
        return fail(ErrorCode::Usage, "a speed is 0, as fast as possible, or from 0.01 to 1000 times real time");
    const std::lock_guard lock{mutex_};
    if (!paused_)
        accountFor(clock_.now());
    speed_ = speed;
    steered_.notify_all();
    return {};
}

/// Takes the time that has run at the present speed off what is left.
void Pacer::accountFor(Nanoseconds now)
{
    if (now <= from_)
        return;
    left_ = std::max(std::chrono::duration<double>{0.0}, left_ - std::chrono::duration<double>{now - from_} * speed_);
    from_ = now;
}

Pacer::Nanoseconds Pacer::due() const
{
    return from_ + std::chrono::duration_cast<Nanoseconds>(left_ / speed_);
}

}  // namespace planewright
