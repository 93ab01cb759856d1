// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/pipeline/step_replay.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <string>
#include <utility>

namespace planewright {

namespace {

constexpr int kAfterAll = std::numeric_limits<int>::max();

}  // namespace

StepReplay::StepReplay(const SensorModel& sensor, const Parameters& parameters)
    : sensor_(sensor), parameters_(parameters)
{
}

void StepReplay::add(std::shared_ptr<const ScanSlice> slice)
{
    assert(slices_.empty() || slices_.back()->step < slice->step);
    // A course that has made its last pass cannot go on.
    if (course_ && course_->next > slices_.size())
        course_.reset();
    slices_.push_back(std::move(slice));
}

void StepReplay::change(const ParametersFrom& change)
{
    std::erase_if(changes_, [&](const ParametersFrom& other) { return other.step >= change.step; });
    const bool isTooLate = course_ && (course_->next > slices_.size() ||
                                       (course_->next > 0 && slices_[course_->next - 1]->step >= change.step));
    if (isTooLate)
        course_.reset();
    changes_.push_back(change);
}

Result<std::size_t> StepReplay::placeOf(int step) const
{
    if (step == kLastPass)
        return slices_.size();
    const auto found = std::lower_bound(
        slices_.begin(), slices_.end(), step,
        [](const std::shared_ptr<const ScanSlice>& slice, int wanted) { return slice->step < wanted; });
    if (found != slices_.end() && (*found)->step == step)
        return static_cast<std::size_t>(found - slices_.begin());
    if (slices_.empty())
        return fail(ErrorCode::Usage, "The scan has no steps yet. Ask again after its first slice.");
    return fail(ErrorCode::Usage, "The scan has no step " + std::to_string(step) + ". Choose one of its " +
                                      std::to_string(slices_.size()) + " steps from " +
                                      std::to_string(slices_.front()->step) + " to " +
                                      std::to_string(slices_.back()->step) + ".");
}

/// The parameters that are in force at a step.
void StepReplay::Course::changeUpTo(int step, const std::vector<ParametersFrom>& all)
{
    for (; changes < all.size() && all[changes].step <= step; ++changes)
        extractor->setParameters(all[changes].parameters);
}

/// Works the slices before a place in, from the start where the course is past it.
void StepReplay::goTo(std::size_t place)
{
    newest_ = nullptr;
    if (!course_ || course_->next > place)
        course_.emplace(sensor_, parameters_, false);
    for (; course_->next < place; ++course_->next) {
        const ScanSlice& slice = *slices_[course_->next];
        course_->changeUpTo(slice.step, changes_);
        // With its snapshot: segments are told with the noise that was known when they were shown first.
        course_->extractor->step(slice);
    }
}

Result<std::shared_ptr<const PhasedStep>> StepReplay::at(int step)
{
    const Result<std::size_t> place = placeOf(step);
    if (!place)
        return tl::unexpected{place.error()};
    if (course_ && newest_ && course_->next == *place + 1)
        return newest_;
    goTo(*place);
    const bool isLast = *place == slices_.size();
    course_->changeUpTo(isLast ? kAfterAll : step, changes_);
    newest_ = std::make_shared<const PhasedStep>(isLast ? course_->extractor->finishByPhases()
                                                        : course_->extractor->stepByPhases(*slices_[*place]));
    ++course_->next;
    return newest_;
}

Result<WhyNot> StepReplay::whyNot(int step, const Operand& a, const Operand& b)
{
    if (const auto there = at(step); !there)
        return tl::unexpected{there.error()};
    return course_->extractor->whyNot(a, b);
}

void StepReplay::visit(bool lastPass, const std::function<void(const Snapshot&)>& visitor) const
{
    Course course(sensor_, parameters_, true);
    for (const auto& slice : slices_) {
        course.changeUpTo(slice->step, changes_);
        visitor(*course.extractor->step(*slice));
    }
    if (!lastPass)
        return;
    course.changeUpTo(kAfterAll, changes_);
    visitor(*course.extractor->finish());
}

}  // namespace planewright
