// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/nodding/tilt_track.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace planewright {

namespace {

constexpr std::chrono::seconds kKept{3};

bool rests(const TiltSample& sample, double pitch, double tolerance)
{
    return !sample.moving && std::abs(sample.pitch - pitch) <= tolerance;
}

}  // namespace

void TiltTrack::add(const TiltSample& sample)
{
    if (!samples_.empty() && sample.at <= samples_.back().at)
        return;
    samples_.push_back(sample);
    while (samples_.front().at < sample.at - kKept)
        samples_.pop_front();
}

std::optional<double> TiltTrack::pitchAt(Time moment, Time reach) const
{
    const Place after = firstFrom(moment);
    if (after == samples_.end() || (after == samples_.begin() && after->at != moment))
        return std::nullopt;
    if (after->at == moment)
        return after->pitch;
    if (skewAt(moment) > reach)
        return std::nullopt;
    const TiltSample& before = *std::prev(after);
    const double share = std::chrono::duration<double>(moment - before.at) / (after->at - before.at);
    return before.pitch + share * (after->pitch - before.pitch);
}

TiltTrack::Time TiltTrack::skewAt(Time moment) const
{
    const Place after = firstFrom(moment);
    if (after == samples_.end() || after == samples_.begin())
        return Time{0};
    return std::min(moment - std::prev(after)->at, after->at - moment);
}

std::optional<double> TiltTrack::meanPitch(Time from, Time to) const
{
    double sum = 0.0;
    int count = 0;
    for (Place sample = firstFrom(from); sample != samples_.end() && sample->at <= to; ++sample, ++count)
        sum += sample->pitch;
    if (count == 0)
        return std::nullopt;
    return sum / count;
}

TiltTrack::Place TiltTrack::firstFrom(Time moment) const
{
    return std::lower_bound(samples_.begin(), samples_.end(), moment,
                            [](const TiltSample& sample, Time t) { return sample.at < t; });
}

bool TiltTrack::isAt(double pitch, double tolerance, Time from, Time to) const
{
    if (samples_.empty() || samples_.back().at < to || samples_.front().at > from)
        return false;
    const auto after = std::upper_bound(samples_.begin(), samples_.end(), from,
                                        [](Time t, const TiltSample& sample) { return t < sample.at; });
    for (auto sample = std::prev(after); sample != samples_.end(); ++sample) {
        if (!rests(*sample, pitch, tolerance))
            return false;
        if (sample->at >= to)
            break;
    }
    return true;
}

std::optional<TiltTrack::Time> TiltTrack::restsSince(double pitch, double tolerance, int least) const
{
    const auto moving = std::find_if(samples_.rbegin(), samples_.rend(),
                                     [&](const TiltSample& sample) { return !rests(sample, pitch, tolerance); });
    if (std::distance(samples_.rbegin(), moving) < least)
        return std::nullopt;
    return moving.base()->at;
}

}  // namespace planewright
