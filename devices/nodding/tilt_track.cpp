// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/nodding/tilt_track.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace planewright {

namespace {

constexpr std::chrono::seconds kKept{3};
/// Units tell their angle every 5 to 20 ms.
constexpr std::chrono::milliseconds kFresh{100};

}  // namespace

void TiltTrack::add(const TiltSample& sample)
{
    if (!samples_.empty() && sample.at <= samples_.back().at)
        return;
    samples_.push_back(sample);
    while (samples_.front().at < sample.at - kKept)
        samples_.pop_front();
}

bool TiltTrack::isFresh(Time now) const
{
    return !isEmpty() && now - last().at <= kFresh;
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

double TiltTrack::Line::pitchAt(Time moment) const
{
    return pitch + speed * std::chrono::duration<double>(moment - at).count();
}

std::optional<TiltTrack::Line> TiltTrack::lineSince(Time from) const
{
    const Place first = firstFrom(from);
    const auto count = std::distance(first, samples_.end());
    if (count < 3)
        return std::nullopt;
    Line line;
    line.at = first->at;
    double meanTime = 0.0;
    for (Place sample = first; sample != samples_.end(); ++sample) {
        meanTime += std::chrono::duration<double>(sample->at - line.at).count();
        line.pitch += sample->pitch;
    }
    const auto n = static_cast<double>(count);
    meanTime /= n;
    line.pitch /= n;
    double timeSquares = 0.0;
    double products = 0.0;
    for (Place sample = first; sample != samples_.end(); ++sample) {
        const double time = std::chrono::duration<double>(sample->at - line.at).count() - meanTime;
        timeSquares += time * time;
        products += time * (sample->pitch - line.pitch);
    }
    line.speed = products / timeSquares;  // samples are at different moments
    line.pitch -= line.speed * meanTime;
    for (Place sample = first; sample != samples_.end(); ++sample)
        line.residual = std::max(line.residual, std::abs(sample->pitch - line.pitchAt(sample->at)));
    return line;
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

std::optional<TiltTrack::Time> TiltTrack::restsSince(double play, int least) const
{
    const auto other = std::find_if(samples_.rbegin(), samples_.rend(), [&](const TiltSample& sample) {
        return std::abs(sample.pitch - last().pitch) > play;
    });
    if (std::distance(samples_.rbegin(), other) < least)
        return std::nullopt;
    return other.base()->at;
}

}  // namespace planewright
