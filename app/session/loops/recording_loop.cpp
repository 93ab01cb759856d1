// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/session/loops/recording_loop.h"

#include <algorithm>
#include <exception>
#include <string>
#include <type_traits>
#include <utility>

#include "core/types/count_text.h"

namespace planewright {

RecordingLoop::RecordingLoop(std::unique_ptr<SliceRecorder> recorder, ScanDescription description,
                             std::optional<int> plannedSlices, const std::vector<ParametersFrom>& parameters,
                             Channel<AcquiredItem>& in, Channel<ExtractionItem>& out, const Clock& clock,
                             RecordingEvents events)
    : recorder_(std::move(recorder)),
      description_(std::move(description)),
      plannedSlices_(plannedSlices),
      in_(in),
      out_(out),
      clock_(clock),
      events_(std::move(events))
{
    if (recorder_)
        held_.assign(parameters.begin(), parameters.end());
}

void RecordingLoop::run()
{
    writeHeld();
    while (!outcome_ && !in_.isDone()) {
        std::optional<AcquiredItem> item = in_.pop(retryAt_);
        if (item)
            take(std::move(*item));
        else
            writeHeld();
    }
    in_.abandon();
    out_.close();
    close();
}

void RecordingLoop::take(AcquiredItem item)
{
    if (const auto* outcome = std::get_if<ScanOutcome>(&item)) {
        outcome_ = *outcome;
    } else if (const auto* slice = std::get_if<SharedSlice>(&item)) {
        lastStep_ = (*slice)->step;
        hold(*slice);
        out_.push(*slice);
    } else if (const auto* parameters = std::get_if<Parameters>(&item)) {
        const ParametersFrom from{lastStep_ + 1, *parameters};
        hold(from);
        out_.push(from);
    } else {
        ScanEvent event = std::get<ScanEvent>(std::move(item));
        event.step = std::max(lastStep_, 0);
        hold(std::move(event));
    }
}

void RecordingLoop::hold(Held item)
{
    if (!recorder_)
        return;
    held_.push_back(std::move(item));
    writeHeld();
}

void RecordingLoop::hurry()
{
    const std::lock_guard lock{mutex_};
    hurries_ = true;
    hurried_.notify_all();
}

/// Writes what is held, if any, unless the last failure is too young.
void RecordingLoop::writeHeld()
{
    if (!recorder_)
        return;
    if (!retryAt_ || clock_.now() >= *retryAt_)
        tryToWriteHeld();
    lookAtDisk();
}

void RecordingLoop::tryToWriteHeld()
{
    while (!begun_ || !held_.empty()) {
        if (const Result<void> written = writeNext(); !written) {
            retryAt_ = clock_.now() + kRetryAfter;
            if (!std::exchange(trouble_, written.error()))
                events_.onTrouble(*trouble_);
            return;
        }
    }
    retryAt_.reset();
    if (std::exchange(trouble_, std::nullopt))
        events_.onRecovered();
}

/// Begins the recording, or writes the first of what is held.
Result<void> RecordingLoop::writeNext()
{
    return guarded([this]() -> Result<void> {
        if (!begun_) {
            if (Result<void> begun = recorder_->begin(description_, plannedSlices_); !begun)
                return begun;
            begun_ = true;
            return {};
        }
        Result<void> written = std::visit(
            [this](const auto& item) {
                if constexpr (std::is_same_v<std::decay_t<decltype(item)>, SharedSlice>)
                    return recorder_->write(*item);
                else
                    return recorder_->write(item);
            },
            held_.front());
        if (written)
            held_.pop_front();
        return written;
    });
}

void RecordingLoop::close()
{
    if (!recorder_)
        return;
    Result<void> closed;
    for (int tries = 0; tries < kLastTries; ++tries) {
        if (tries > 0) {
            if (hurries_)
                break;
            const auto until = clock_.now() + kRetryAfter;
            std::unique_lock lock{mutex_};
            while (!hurries_ && clock_.now() < until)
                clock_.wait(lock, hurried_, {}, until);
        }
        retryAt_.reset();
        writeHeld();
        closed = trouble_ ? fail(trouble_->code, trouble_->message)
                          : guarded([this] { return recorder_->close(outcome_.value_or(ScanOutcome::Partial)); });
        if (closed)
            break;
    }
    lookAtDisk();
    if (!closed && !held_.empty()) {
        const auto slices =
            std::ranges::count_if(held_, [](const Held& item) { return std::holds_alternative<SharedSlice>(item); });
        const auto lost = slices > 0 ? slices : static_cast<std::ptrdiff_t>(held_.size());
        closed =
            fail(closed.error().code, closed.error().message + "; " + countText(lost, slices > 0 ? "slice" : "note") +
                                          " of this scan " + (lost == 1 ? "is" : "are") + " not on the disk");
    }
    events_.onClosed(closed);
}

/// Exceptions of a recorder, as for want of memory, are failures to write like others.
Result<void> RecordingLoop::guarded(const std::function<Result<void>()>& write) const
try {
    return write();
} catch (const std::exception& exception) {
    return fail(ErrorCode::NotWritten, recorder_->path() + ": internal error: " + exception.what());
}

void RecordingLoop::lookAtDisk()
{
    const auto now = clock_.now();
    const bool isDue = now >= lookedAtDisk_ + kRetryAfter;
    RecordingStatus status = this->status();
    status.notOnDisk = held_.size();
    if (isDue || outcome_) {
        lookedAtDisk_ = now;
        status.bytes = recorder_->bytes();
        status.freeBytes = recorder_->freeBytes();
    }
    const std::lock_guard lock{mutex_};
    status_ = status;
}

RecordingStatus RecordingLoop::status() const
{
    const std::lock_guard lock{mutex_};
    return status_;
}

}  // namespace planewright
