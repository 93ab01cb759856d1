// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/session/idle_run.h"

#include <utility>

namespace planewright {

IdleRun::IdleRun(std::shared_ptr<ScanSource> source, const Clock& clock)
    : source_(std::move(source)),
      loop_(*source_, clock,
            {[this](const Result<std::optional<double>>& pitch) {
                 QMetaObject::invokeMethod(
                     this,
                     [this, pitch] {
                         if (pitch)
                             emit cameHome(*pitch);
                         else
                             emit homeFailed(pitch.error());
                     },
                     Qt::QueuedConnection);
             },
             [this](const std::vector<FaultRecord>& records) {
                 QMetaObject::invokeMethod(
                     this, [this, records] { emit devicesTroubled(records); }, Qt::QueuedConnection);
             }}),
      thread_(QThread::create([this] { loop_.run(); }))
{
    thread_->start();
}

IdleRun::~IdleRun()
{
    loop_.finish();
    thread_->wait();
}

}  // namespace planewright
