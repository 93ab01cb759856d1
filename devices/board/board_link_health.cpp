// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/board/board_link.h"

namespace planewright {

using namespace board;

namespace {

using namespace std::chrono_literals;
using Time = BoardLink::Time;

constexpr Time kLossIsNews = 2s;
/// With slower heartbeats than this an angle's moment is not known to 5 ms, and an angle without its moment is none.
constexpr Time kSlowestRoundTrip = 10ms;

}  // namespace

LinkHealth BoardLink::health() const
{
    const std::scoped_lock lock(mutex_);
    const FrameParser::Counters& counters = parser_.counters();
    LinkHealth health;
    health.rate = rate_.at(clock_.now());
    health.good = counters.frames;
    health.lost = counters.lostEvents + missing_;
    health.corrupt = counters.damaged() + unreadable_;
    if (lostEvents_ > 0 && clock_.now() - lostAt_ < kLossIsNews)
        health.trouble = "events of the control board were lost (" + std::to_string(lostEvents_) +
                         " since it was connected); slices of these moments are missing";
    if (isTooSlow())
        health.trouble = "the control board " + slownessText();
    const TransportHealth transport = transport_->health();
    health.overruns = transport.overruns;
    if (health.trouble.empty())
        health.trouble = transport.trouble;
    health.faults = log_.counts();
    return health;
}

std::string BoardLink::slowness() const
{
    const std::scoped_lock lock(mutex_);
    return isTooSlow() ? slownessText() : std::string{};
}

bool BoardLink::isTooSlow() const
{
    return sync_.isSynchronised() && sync_.roundTrip() > kSlowestRoundTrip;
}

std::string BoardLink::slownessText() const
{
    const auto in = [](Time time) {
        return std::to_string(std::chrono::round<std::chrono::milliseconds>(time).count()) + " ms";
    };
    return "answers too slowly: its answers take " + in(sync_.roundTrip()) +
           ", and the moments of its angles must be known to " + in(kSlowestRoundTrip / 2) +
           "; connect it to the computer directly, without a hub or a network between them";
}

}  // namespace planewright
