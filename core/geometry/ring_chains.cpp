// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/geometry/ring_chains.h"

#include <algorithm>
#include <utility>

namespace planewright {

void RingChains::add(const Strip& strip, const StripCorners& c)
{
    const Eigen::Vector2d before = c.beforeHigh - c.beforeLow;
    const Eigen::Vector2d after = c.afterHigh - c.afterLow;
    // Signed distances (times a length) of each stretch's ends from the line of the other one.
    const double afterLow = cross(before, c.afterLow - c.beforeLow);
    const double afterHigh = cross(before, c.afterHigh - c.beforeLow);
    const double beforeLow = cross(after, c.beforeLow - c.afterLow);
    const double beforeHigh = cross(after, c.beforeHigh - c.afterLow);
    if (afterLow * afterHigh < 0.0 && beforeLow * beforeHigh < 0.0) {
        // Near the pitch axis, and where slices come out of order, the stretches cross.
        const Eigen::Vector2d crossing = c.beforeLow + beforeLow / (beforeLow - beforeHigh) * before;
        chains_.push_back({afterLow < 0.0, strip.ends, {c.beforeLow, c.afterLow}, {crossing}});
        chains_.push_back({afterHigh < 0.0, strip.ends, {crossing}, {c.beforeHigh, c.afterHigh}});
        return;
    }
    const double doubledArea =
        cross(c.afterHigh - c.beforeLow, c.afterLow - c.beforeLow) + cross(before, c.afterHigh - c.beforeLow);
    const bool turned = doubledArea < 0.0;
    std::size_t& chain = chainAt_[strip.before];
    if (chain != kNone && chains_[chain].turned == turned && chains_[chain].ends[0].after == strip.ends[0].before &&
        chains_[chain].ends[1].after == strip.ends[1].before) {
        chains_[chain].ends = strip.ends;
        chains_[chain].low.push_back(c.afterLow);
        chains_[chain].high.push_back(c.afterHigh);
        chainAt_[strip.after] = chain;
        chain = kNone;
    } else {
        chainAt_[strip.after] = chains_.size();
        chains_.push_back({turned, strip.ends, {c.beforeLow, c.afterLow}, {c.beforeHigh, c.afterHigh}});
    }
}

std::vector<PlanarRing> RingChains::rings() const
{
    std::vector<PlanarRing> rings;
    for (const Chain& chain : chains_) {
        PlanarRing ring = chain.high;
        ring.insert(ring.end(), chain.low.rbegin(), chain.low.rend());
        if (chain.turned)
            std::ranges::reverse(ring);
        rings.push_back(std::move(ring));
    }
    return rings;
}

}  // namespace planewright
