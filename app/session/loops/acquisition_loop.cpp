// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/session/loops/acquisition_loop.h"

#include <exception>
#include <utility>

#include "core/formats/recorded_slice.h"

namespace planewright {

namespace {

constexpr std::size_t kTimesKept = 41;  // a second of a scanner that takes 40 slices in one

}  // namespace

AcquisitionLoop::AcquisitionLoop(ScanSource& source, Channel<AcquiredItem>& out, const Clock& clock,
                                 AcquisitionEvents events)
    : source_(source), out_(out), clock_(clock), events_(std::move(events))
{
}

void AcquisitionLoop::run()
{
    const ScanOutcome outcome = takeSlices();
    // Where even that fails nothing is left to be done here: the device's own watchdog stops it.
    [[maybe_unused]] const Result<void> stopped = source_.stopMotion();
    out_.push(outcome);
    events_.onEnded(outcome);
}

ScanOutcome AcquisitionLoop::takeSlices()
{
    for (bool begun = false;;) {
        const Result<bool> taken = takeSlice(begun);
        if (taken && *taken)
            continue;
        if (taken) {
            const bool isWhole = source_.plannedSlices().value_or(-1) == slices_;
            return stop_.stop_requested() && !isWhole ? ScanOutcome::Partial : ScanOutcome::Complete;
        }
        out_.push(ScanEvent{ScanEvent::Kind::Fault, {}, {}, taken.error().message});
        forgetVerdict();
        events_.onFault(taken.error());
        if (waitForVerdict() == Verdict::GiveUp)
            return ScanOutcome::Fault;
        out_.push(ScanEvent{ScanEvent::Kind::Recovered, {}, {}, {}});
    }
}

/// Goes to the beginning of the scan, or takes its next slice; false where there is none.
Result<bool> AcquisitionLoop::takeSlice(bool& begun)
try {
    if (!begun) {
        if (const Result<void> done = source_.begin(stop_.get_token()); !done)
            return tl::unexpected{done.error()};
        begun = true;
        if (!stop_.stop_requested())
            events_.onBegun();
    }
    Result<std::optional<ScanSlice>> slice = source_.next(stop_.get_token());
    if (!slice)
        return tl::unexpected{slice.error()};
    if (!*slice)
        return false;
    handOn(source_.isLive() ? asRecorded(std::move(**slice)) : std::move(**slice));
    return true;
} catch (const std::exception& exception) {
    return fail(ErrorCode::Internal, source_.name() + ": internal error: " + exception.what());
}

/// What was said of the fault before holds no more.
void AcquisitionLoop::forgetVerdict()
{
    const std::lock_guard lock{mutex_};
    verdict_.reset();
}

AcquisitionLoop::Verdict AcquisitionLoop::waitForVerdict()
{
    std::unique_lock lock{mutex_};
    while (!verdict_ && !stop_.stop_requested())
        clock_.wait(lock, judged_, stop_.get_token(), std::nullopt);
    return std::exchange(verdict_, std::nullopt).value_or(Verdict::GiveUp);
}

void AcquisitionLoop::handOn(ScanSlice slice)
{
    if (lastStep_)
        lost_ += slice.step - *lastStep_ - 1;
    lastStep_ = slice.step;
    out_.push(std::make_shared<const ScanSlice>(std::move(slice)));
    ++slices_;
    const std::lock_guard lock{mutex_};
    times_.push_back(clock_.now());
    if (times_.size() > kTimesKept)
        times_.pop_front();
}

void AcquisitionLoop::retry()
{
    const std::lock_guard lock{mutex_};
    verdict_ = Verdict::Retry;
    judged_.notify_all();
}

void AcquisitionLoop::giveUp()
{
    const std::lock_guard lock{mutex_};
    verdict_ = Verdict::GiveUp;
    judged_.notify_all();
}

double AcquisitionLoop::slicesPerSecond() const
{
    const std::lock_guard lock{mutex_};
    if (times_.size() < 2)
        return 0.0;
    const std::chrono::duration<double> span = times_.back() - times_.front();
    return span.count() > 0.0 ? static_cast<double>(times_.size() - 1) / span.count() : 0.0;
}

}  // namespace planewright
