// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/window/background_work.h"

#include <utility>

namespace planewright {

BackgroundWork::BackgroundWork(QObject* parent) : QObject(parent)
{
    thread_.setMaxThreadCount(1);
}

BackgroundWork::~BackgroundWork()
{
    thread_.waitForDone();
}

void BackgroundWork::run(std::function<void()> work, std::function<void()> then)
{
    ++pending_;
    thread_.start([this, work = std::move(work), then = std::move(then)] {
        work();
        QMetaObject::invokeMethod(
            this,
            [this, then] {
                --pending_;
                then();
            },
            Qt::QueuedConnection);
    });
}

}  // namespace planewright
