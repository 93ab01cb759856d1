// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/session/scan_history.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace planewright {

ScanHistory::ScanHistory(ScanDescription description, int plannedSteps)
    : description_(std::move(description)), plannedSteps_(plannedSteps)
{
}

void ScanHistory::add(std::vector<ExtractedStep> steps)
{
    for (ExtractedStep& step : steps) {
        addToReplay(step);
        lives_.add(*step.snapshot);
        if (step.slice)
            slices_.push_back(step.slice);
        steps_.push_back(std::move(step));
    }
}

void ScanHistory::addToReplay(const ExtractedStep& step)
{
    if (!replay_)
        replay_.emplace(sensorOf(description_), *step.parameters);
    else if (step.parameters != steps_.back().parameters)
        replay_->change({step.slice ? step.slice->step : slices_.back()->step + 1, *step.parameters});
    if (step.slice)
        replay_->add(step.slice);
}

Result<std::shared_ptr<const PhasedStep>> ScanHistory::explained(int step)
{
    if (!replay_)
        return fail(ErrorCode::Usage, "The scan has no steps yet. Ask again after its first slice.");
    return replay_->at(step);
}

Result<WhyNot> ScanHistory::whyNot(int step, const Operand& a, const Operand& b)
{
    if (!replay_)
        return fail(ErrorCode::Usage, "The scan has no steps yet. Ask again after its first slice.");
    return replay_->whyNot(step, a, b);
}

std::vector<SharedSlice> ScanHistory::measured() const
{
    std::vector<SharedSlice> measured;
    for (const ExtractedStep& step : steps_) {
        if (step.measured)
            measured.push_back(step.measured);
    }
    return measured;
}

std::shared_ptr<const SessionMap> ScanHistory::newest() const
{
    return after(steps_.size());
}

std::shared_ptr<const SessionMap> ScanHistory::at(int step) const
{
    const auto next = std::upper_bound(slices_.begin(), slices_.end(), step,
                                       [](int limit, const SharedSlice& slice) { return limit < slice->step; });
    if (next == slices_.end())
        return newest();
    return after(static_cast<std::size_t>(std::distance(slices_.begin(), next)));
}

std::shared_ptr<const SessionMap> ScanHistory::after(std::size_t count) const
{
    const std::size_t steps = std::min(count, steps_.size());
    auto map = std::make_shared<SessionMap>();
    const std::size_t slices = std::min(steps, slices_.size());
    map->slices.assign(slices_.begin(), slices_.begin() + static_cast<std::ptrdiff_t>(slices));
    map->sensor = sensorOf(description_);
    map->plannedSteps = plannedSteps_;
    map->isNewest = steps == steps_.size();
    if (steps > 0) {
        map->snapshot = steps_[steps - 1].snapshot;
        map->finished = steps_[steps - 1].slice == nullptr;
    }
    if (slices > 0)
        map->step = map->slices.back()->step;
    return map;
}

}  // namespace planewright
