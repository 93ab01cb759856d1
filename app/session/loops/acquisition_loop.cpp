// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/session/loops/acquisition_loop.h"

#include <algorithm>
#include <exception>
#include <utility>

#include "core/formats/recorded_slice.h"

namespace planewright {

namespace {

constexpr std::size_t kTimesKept = 41;  // a second of a scanner that takes 40 slices in one
constexpr std::chrono::milliseconds kFirstWait{500};
constexpr std::chrono::milliseconds kLongestWait{2000};
constexpr int kWaitsDoubled = 2;
constexpr std::chrono::seconds kBetweenRecords{1};

}  // namespace

AcquisitionLoop::AcquisitionLoop(ScanSource& source, Channel<AcquiredItem>& out, const Clock& clock,
                                 AcquisitionEvents events, AutomaticRecovery recovery)
    : source_(source), out_(out), clock_(clock), events_(std::move(events)), recovery_(recovery)
{
}

void AcquisitionLoop::run()
{
    const ScanOutcome outcome = takeSlices();
    // Where even that fails nothing is left to be done here: the device's own watchdog stops it.
    [[maybe_unused]] const Result<void> rested = source_.end();
    tellRecords();
    out_.push(outcome);
    events_.onEnded(outcome);
}

ScanOutcome AcquisitionLoop::takeSlices()
{
    for (bool begun = false;;) {
        const Result<bool> taken = takeSlice(begun);
        if (taken && *taken) {
            tellRecordsNowAndThen();
            continue;
        }
        const bool isOver = taken || taken.error().code == ErrorCode::Interrupted;
        tellRecords(isOver ? nullptr : &taken.error());
        if (isOver)
            return outcomeOfTheEnd();
        out_.push(ScanEvent{ScanEvent::Kind::Fault, {}, {}, taken.error().message});
        if (judge(taken.error()) == Verdict::GiveUp)
            return ScanOutcome::Fault;
        out_.push(ScanEvent{ScanEvent::Kind::Recovered, {}, {}, {}});
    }
}

void AcquisitionLoop::tellRecordsNowAndThen()
{
    if (clock_.now() - toldAt_ >= kBetweenRecords)
        tellRecords();
}

void AcquisitionLoop::tellRecords(const Error* fault)
{
    toldAt_ = clock_.now();
    if (const std::vector<FaultRecord> records = source_.takeLog(); !records.empty() && events_.onRecords)
        events_.onRecords(records, fault);
}

ScanOutcome AcquisitionLoop::outcomeOfTheEnd()
{
    const std::optional<int> planned = source_.plannedSlices();
    const bool isWhole = planned == slices_.load();
    if (source_.isLive() && planned && !stop_.stop_requested())
        lost_ = std::max(lost_.load(), *planned - slices_);
    return isWhole || (!planned && !stop_.stop_requested()) ? ScanOutcome::Complete : ScanOutcome::Partial;
}

/// What to do after a fault: tries again by itself as far as it may, or asks.
AcquisitionLoop::Verdict AcquisitionLoop::judge(const Error& error)
{
    forgetVerdict();
    if (const auto wait = waitBeforeRetry(error)) {
        if (events_.onRecovering)
            events_.onRecovering(error, *wait);
        return waitForVerdict(clock_.now() + *wait).value_or(Verdict::Retry);
    }
    triesInARow_ = 0;
    events_.onFault(error);
    return waitForVerdict(std::nullopt).value_or(Verdict::GiveUp);
}

/// How long to wait before trying again unasked; empty where somebody has to be asked.
std::optional<std::chrono::milliseconds> AcquisitionLoop::waitBeforeRetry(const Error& error)
{
    // While a device is away it is no longer found, either.
    const bool isOfTheLink = error.code == ErrorCode::DeviceLost || error.code == ErrorCode::NoDevice;
    if (!isOfTheLink || stop_.stop_requested() || triesInARow_ >= recovery_.mostInARow || tries_ >= recovery_.mostInAll)
        return std::nullopt;
    const auto wait = std::min(kFirstWait * (1 << std::min(triesInARow_, kWaitsDoubled)), kLongestWait);
    ++triesInARow_;
    ++tries_;
    return wait;
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

/// Empty where the moment has come before anybody has said anything. After finish() nobody needs to.
std::optional<AcquisitionLoop::Verdict> AcquisitionLoop::waitForVerdict(std::optional<std::chrono::nanoseconds> until)
{
    std::unique_lock lock{mutex_};
    while (!verdict_ && !stop_.stop_requested() && (!until || clock_.now() < *until))
        clock_.wait(lock, judged_, stop_.get_token(), until);
    if (stop_.stop_requested())
        verdict_ = Verdict::GiveUp;
    return std::exchange(verdict_, std::nullopt);
}

void AcquisitionLoop::handOn(ScanSlice slice)
{
    if (lastStep_)
        lost_ += slice.step - *lastStep_ - 1;
    else if (source_.isLive())
        lost_ += slice.step;
    triesInARow_ = 0;
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
