// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "app/session/loops/scan_pipeline.h"
#include "core/simulation/nodding_scanner.h"
#include "devices/scan_source.h"

namespace planewright {

/// A small scan of the corridor, quick under any sanitizer: 40 slices of 91 beams.
inline AcquisitionSettings smallScan()
{
    AcquisitionSettings settings;
    settings.tiltStep = degrees(4.0);
    settings.slices = 40;
    settings.bearingStep = degrees(2.0);
    settings.beams = 91;
    return settings;
}

/// A scanner that gives the slices it is told to, and fails where it is told to.
class ScriptedSource : public ScanSource {
public:
    explicit ScriptedSource(Recording recording, bool live = true) : recording_(std::move(recording)), live_(live) {}

    std::function<Result<void>(int call)> onNext;   ///< before each slice; an error is what next() gives
    std::function<Result<void>(int call)> onBegin;  ///< with the number of the call, from 1
    std::optional<int> planned;                     ///< where it is not the slices that there are
    int firstStep = 0;                              ///< is added to the steps of its slices
    std::function<std::vector<FaultRecord>()> onTakeLog;
    std::function<void(const std::stop_token&)> onLook;
    std::function<Result<std::optional<double>>(const std::stop_token&)> onHome;
    bool endless = false;  ///< after the last slice it waits for a stop

    const ScanDescription& description() const override { return recording_.description; }
    std::optional<int> plannedSlices() const override
    {
        return planned.value_or(static_cast<int>(recording_.slices.size()));
    }
    bool isLive() const override { return live_; }
    std::string name() const override { return "Scripted scanner"; }
    Result<void> begin(const std::stop_token& /*stop*/) override
    {
        at_ = 0;
        ++begins;
        return onBegin ? onBegin(begins) : Result<void>{};
    }
    Result<std::optional<ScanSlice>> next(const std::stop_token& stop) override
    {
        if (stop.stop_requested())
            return std::nullopt;
        if (onNext) {
            if (const Result<void> done = onNext(calls_++); !done)
                return tl::unexpected{done.error()};
        }
        if (at_ < recording_.slices.size()) {
            ScanSlice slice = recording_.slices[at_++];
            slice.step += firstStep;
            return slice;
        }
        while (endless && !stop.stop_requested())
            std::this_thread::sleep_for(std::chrono::milliseconds{1});
        return std::nullopt;
    }
    void lookAfter(const std::stop_token& stop) override
    {
        ++looks;
        if (onLook)
            onLook(stop);
    }
    Result<std::optional<double>> goHome(const std::stop_token& stop) override
    {
        return onHome ? onHome(stop) : Result<std::optional<double>>{std::nullopt};
    }
    std::vector<FaultRecord> takeLog() override { return onTakeLog ? onTakeLog() : std::vector<FaultRecord>{}; }
    Result<void> pause() override { return {}; }
    Result<void> resume() override { return {}; }
    Result<void> end() override
    {
        ++ends;
        return {};
    }
    Result<void> stopMotion() override
    {
        ++stops;
        return {};
    }
    void release() override { ++releases; }

    std::atomic<int> looks{0};
    std::atomic<int> begins{0};
    std::atomic<int> ends{0};
    std::atomic<int> stops{0};
    std::atomic<int> releases{0};

private:
    Recording recording_;
    bool live_;
    std::size_t at_ = 0;
    int calls_ = 0;
};

/// What a recorder was given: more than one thread may look.
struct RecordedScan {
    std::mutex mutex;
    std::vector<std::string> lines;  ///< "begin", "slice 3", "parameters 0", "event pause", "close complete"
    std::atomic<bool> fails{false};
    std::atomic<bool> isSlow{false};  ///< nothing is written while it is
    std::atomic<int> refused{0};
    std::atomic<bool> isOpen{false};

    std::vector<std::string> copy()
    {
        const std::lock_guard lock{mutex};
        return lines;
    }
    int slices()
    {
        const std::lock_guard lock{mutex};
        return static_cast<int>(std::count_if(lines.begin(), lines.end(),
                                              [](const std::string& line) { return line.starts_with("slice"); }));
    }
};

/// A recorder without a disk, that fails while it is told to.
class FakeRecorder : public SliceRecorder {
public:
    explicit FakeRecorder(std::shared_ptr<RecordedScan> scan) : scan_(std::move(scan)) {}

    std::string path() const override { return "scan.pwscan"; }
    Result<void> begin(const ScanDescription& /*description*/, std::optional<int> /*planned*/) override
    {
        const Result<void> done = note("begin");
        if (done)
            scan_->isOpen = true;
        return done;
    }
    Result<void> write(const ScanSlice& slice) override
    {
        while (scan_->isSlow)
            std::this_thread::sleep_for(std::chrono::milliseconds{1});
        return note("slice " + std::to_string(slice.step));
    }
    Result<void> write(const ParametersFrom& from) override { return note("parameters " + std::to_string(from.step)); }
    Result<void> write(const ScanEvent& event) override { return note("event " + std::string{name(event.kind)}); }
    Result<void> close(ScanOutcome outcome) override
    {
        const char* const words[]{"close complete", "close partial", "close fault"};
        const Result<void> done = note(words[static_cast<int>(outcome)]);
        if (done)
            scan_->isOpen = false;
        return done;
    }
    std::uint64_t bytes() const override { return static_cast<std::uint64_t>(scan_->slices()) * 100; }
    std::optional<std::uint64_t> freeBytes() const override { return 1'000'000; }

private:
    Result<void> note(std::string line)
    {
        if (scan_->fails) {
            ++scan_->refused;
            return fail(ErrorCode::NotWritten, "scan.pwscan: the disk is full; free some space");
        }
        const std::lock_guard lock{scan_->mutex};
        scan_->lines.push_back(std::move(line));
        return {};
    }

    std::shared_ptr<RecordedScan> scan_;
};

/// Some slices without echoes, of consecutive steps.
inline Recording emptySlices(int count)
{
    Recording recording;
    recording.description.beams = 3;
    recording.description.rangeMax = 30.0;
    for (int step = 0; step < count; ++step) {
        ScanSlice slice;
        slice.step = step;
        slice.time = step * std::chrono::milliseconds{25};
        slice.ranges = {0.0, 0.0, 0.0};
        recording.slices.push_back(slice);
    }
    return recording;
}

}  // namespace planewright
