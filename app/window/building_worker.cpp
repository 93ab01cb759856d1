// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/window/building_worker.h"

#include <utility>

namespace planewright {

BuildingWorker::BuildingWorker(QObject* parent)
    : QObject(parent), thread_([this](const std::stop_token& stop) { run(stop); })
{
}

BuildingWorker::~BuildingWorker()
{
    cancel();
    thread_.request_stop();
    thread_.join();
}

void BuildingWorker::make(BuildingRequest request)
{
    ++wanted_;
    {
        const std::scoped_lock lock(mutex_);
        giveUp_.request_stop();
        giveUp_ = std::stop_source();
        next_ = std::move(request);
        nextNumber_ = wanted_;
    }
    wake_.notify_all();
}

void BuildingWorker::cancel()
{
    told_ = ++wanted_;
    const std::scoped_lock lock(mutex_);
    giveUp_.request_stop();
    next_.reset();
}

void BuildingWorker::post(int number, std::function<void()> what)
{
    QMetaObject::invokeMethod(
        this,
        [this, number, what = std::move(what)] {
            if (number == wanted_)
                what();
        },
        Qt::QueuedConnection);
}

void BuildingWorker::run(const std::stop_token& stop)
{
    BuildingMaker maker;
    for (;;) {
        std::optional<BuildingRequest> request;
        std::stop_token giveUp;
        int number = 0;
        {
            std::unique_lock lock(mutex_);
            if (!wake_.wait(lock, stop, [this] { return next_.has_value(); }))
                return;
            request = std::exchange(next_, std::nullopt);
            number = nextNumber_;
            giveUp = giveUp_.get_token();
        }
        const auto tell = [this, number](const char* what, std::size_t done, std::size_t all) {
            post(number, [this, what = QString::fromLatin1(what), done, all] {
                emit progressed(what, static_cast<int>(done), static_cast<int>(all));
            });
        };
        auto map = maker.make(*request, tell, giveUp);
        post(number, [this, number, map = std::move(map)] {
            told_ = number;
            if (map)
                emit made(*map);
            else
                emit failed(map.error());
        });
    }
}

}  // namespace planewright
