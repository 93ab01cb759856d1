// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/session/source_opener.h"

#include <exception>
#include <utility>

namespace planewright {

namespace {

Result<OpenedSource> openGuarded(const SourceAddress& address, const SourceSetup& setup, const Clock& clock,
                                 const std::stop_token& stop)
try {
    return openSource(address, setup, clock, stop);
} catch (const std::exception& exception) {
    return fail(ErrorCode::Internal, address.name + ": internal error: " + exception.what());
}

}  // namespace

SourceOpener::~SourceOpener()
{
    cancel();
    for (const auto& thread : threads_)
        thread->wait();
}

void SourceOpener::open(const SourceAddress& address, const SourceSetup& setup)
{
    cancel();
    forgetEnded();
    stop_ = {};
    const int number = number_;
    threads_.emplace_back(QThread::create([this, address, setup, number, stop = stop_.get_token()] {
        auto result = std::make_shared<Result<OpenedSource>>(openGuarded(address, setup, clock_, stop));
        QMetaObject::invokeMethod(
            this,
            [this, result, number] {
                if (number == number_)
                    emit opened(result);
            },
            Qt::QueuedConnection);
    }));
    threads_.back()->start();
}

void SourceOpener::cancel()
{
    ++number_;
    stop_.request_stop();
}

void SourceOpener::forgetEnded()
{
    std::erase_if(threads_, [](const auto& thread) { return thread->isFinished() && thread->wait(); });
}

}  // namespace planewright
