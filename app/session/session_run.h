// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <vector>

#include <QObject>
#include <QThread>

#include "app/session/loops/scan_pipeline.h"

namespace planewright {

/// Runs the loops of a scan on QThreads of their own, and brings what they tell into its own thread.
///
/// Its end stops them: as soon as a step, a slice or a call of the recorder is done.
class SessionRun : public QObject {
    Q_OBJECT

public:
    /// `make` makes the work with the events that it is given. Nothing runs before start().
    explicit SessionRun(const std::function<std::unique_ptr<ScanWork>(const ScanEvents&)>& make);
    ~SessionRun() override;

    void start();
    ScanWork& work() { return *work_; }
    const ScanWork& work() const { return *work_; }

signals:
    void begun();
    void sourceFailed(const planewright::Error& error);
    /// It is tried again by itself.
    void sourceRecovering(const planewright::Error& error, std::chrono::milliseconds wait);
    void devicesTroubled(const std::vector<planewright::FaultRecord>& records);
    void sourceEnded();
    void recordingTroubled(const planewright::Error& error);
    void recordingRecovered();
    void recordingClosed();
    void recordingGivenUp(const planewright::Error& error);
    void extractionFailed(const planewright::Error& error);
    /// work().take() gives something.
    void news();
    /// All threads have ended; nothing else comes.
    void ended();

private:
    /// Calls it in this object's thread, after all that was posted before.
    template <class Call>
    void post(Call call)
    {
        QMetaObject::invokeMethod(this, std::move(call), Qt::QueuedConnection);
    }
    ScanEvents events();
    void runLoop(const std::function<void()>& loop);

    std::unique_ptr<ScanWork> work_;
    std::vector<std::unique_ptr<QThread>> threads_;
    std::size_t endedThreads_ = 0;
};

}  // namespace planewright
