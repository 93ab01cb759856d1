// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/session/session_run.h"

#include <exception>
#include <string>
#include <utility>

namespace planewright {

SessionRun::SessionRun(const std::function<std::unique_ptr<ScanWork>(const ScanEvents&)>& make) : work_(make(events()))
{
}

SessionRun::~SessionRun()
{
    work_->abandon();
    for (const auto& thread : threads_)
        thread->wait();
}

ScanEvents SessionRun::events()
{
    ScanEvents events;
    events.acquisition.onBegun = [this] { post([this] { emit begun(); }); };
    events.acquisition.onFault = [this](const Error& error) { post([this, error] { emit sourceFailed(error); }); };
    events.acquisition.onEnded = [this](ScanOutcome /*outcome*/) { post([this] { emit sourceEnded(); }); };
    events.acquisition.onRecovering = [this](const Error& error, std::chrono::milliseconds wait) {
        post([this, error, wait] { emit sourceRecovering(error, wait); });
    };
    events.acquisition.onRecords = [this](const std::vector<FaultRecord>& records, const Error* /*fault*/) {
        post([this, records] { emit devicesTroubled(records); });
    };
    events.recording.onTrouble = [this](const Error& error) { post([this, error] { emit recordingTroubled(error); }); };
    events.recording.onRecovered = [this] { post([this] { emit recordingRecovered(); }); };
    events.recording.onClosed = [this](const Result<void>& closed) {
        if (closed)
            post([this] { emit recordingClosed(); });
        else
            post([this, error = closed.error()] { emit recordingGivenUp(error); });
    };
    events.onExtractionFailed = [this](const Error& error) { post([this, error] { emit extractionFailed(error); }); };
    events.onNews = [this] { post([this] { emit news(); }); };
    return events;
}

void SessionRun::start()
{
    for (auto& loop : work_->loops())
        threads_.emplace_back(QThread::create([this, run = std::move(loop)] { runLoop(run); }));
    for (const auto& thread : threads_)
        thread->start();
}

void SessionRun::runLoop(const std::function<void()>& loop)
{
    try {
        loop();
    } catch (const std::exception& exception) {
        // The others would wait for this one.
        work_->abandon();
        const Error error{ErrorCode::Internal, std::string{"the scan ended by an internal error: "} + exception.what()};
        post([this, error] { emit extractionFailed(error); });
    }
    post([this] {
        if (++endedThreads_ == threads_.size())
            emit ended();
    });
}

}  // namespace planewright
