// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/scip/scip_health.h"

#include <algorithm>
#include <utility>

namespace planewright {

namespace {

constexpr std::chrono::seconds kRateOver{1};
/// Of a hundred scans that came, more than this many damaged are no accident.
constexpr std::uint64_t kPercentCorrupt = 1;
/// Fewer tell nothing of a share.
constexpr std::uint64_t kEnoughCorrupt = 5;

}  // namespace

void ScipHealth::restart()
{
    const std::scoped_lock lock(mutex_);
    counters_ = {};
    recent_.clear();
    log_.restartCounts();
}

void ScipHealth::countGood(Time arrived, bool isLate)
{
    const std::scoped_lock lock(mutex_);
    ++counters_.good;
    if (isLate)
        ++counters_.late;
    recent_.push_back(arrived);
    while (recent_.front() <= arrived - kRateOver)
        recent_.pop_front();
}

void ScipHealth::countCorrupt()
{
    const std::scoped_lock lock(mutex_);
    ++counters_.corrupt;
}

void ScipHealth::countLost(std::uint64_t scans)
{
    const std::scoped_lock lock(mutex_);
    counters_.lost += scans;
}

void ScipHealth::log(Time at, std::string_view code, std::string text, std::string_view bytes)
{
    log_.add(at, code, std::move(text), textBytes(bytes));
}

void ScipHealth::setTrouble(std::string trouble)
{
    const std::scoped_lock lock(mutex_);
    counters_.trouble = std::move(trouble);
}

LinkHealth ScipHealth::read(Time now) const
{
    const std::scoped_lock lock(mutex_);
    LinkHealth health = counters_;
    health.faults = log_.counts();
    const auto isRecent = [&](Time arrived) { return arrived > now - kRateOver; };
    health.rate = static_cast<double>(std::count_if(recent_.begin(), recent_.end(), isRecent));
    const std::uint64_t came = health.good + health.corrupt;
    if (health.trouble.empty() && health.corrupt >= kEnoughCorrupt && 100 * health.corrupt > kPercentCorrupt * came)
        health.trouble = "many scans come damaged: check the cable and its plugs";
    return health;
}

}  // namespace planewright
