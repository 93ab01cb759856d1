// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/window/map_worker.h"

#include <utility>

#include "core/pipeline/apply_edits.h"

namespace planewright {

namespace {

/// While slices come, the next map shows the new outlines as well: a picture only for them would hold up the others.
constexpr std::chrono::milliseconds kMoreAfter{100};

std::shared_ptr<ShownMap> withEdits(const MapRequest& request, QStringList& problems)
{
    auto shown = std::make_shared<ShownMap>();
    const SessionMap& map = *request.map;
    shown->snapshot = map.snapshot;
    shown->slices = map.slices;
    shown->sensor = map.sensor;
    shown->step = map.step;
    shown->plannedSteps = map.plannedSteps;
    shown->finished = map.finished;
    if (!map.snapshot)
        return shown;
    EditedPlanes edited = applyEdits(*map.snapshot, request.edits, request.description, request.parameters);
    for (const std::string& problem : edited.problems)
        problems.push_back(QString::fromStdString(problem));
    for (EditedPlane& plane : edited.planes)
        shown->planes.push_back({std::move(plane.plane), std::move(plane.name), std::move(plane.className),
                                 plane.hidden, plane.locked, nullptr});
    return shown;
}

}  // namespace

MapWorker::MapWorker(QObject* parent)
    : QObject(parent),
      outlines_([this] {
          post([this] {
              if (!more_.isActive())
                  more_.start();
          });
      }),
      thread_([this](const std::stop_token& stop) { run(stop); })
{
    more_.setSingleShot(true);
    more_.setInterval(kMoreAfter);
    connect(&more_, &QTimer::timeout, this, &MapWorker::showMore);
}

MapWorker::~MapWorker()
{
    thread_.request_stop();
    thread_.join();
}

void MapWorker::show(MapRequest request)
{
    {
        const std::lock_guard lock(mutex_);
        next_ = std::move(request);
    }
    wake_.notify_one();
}

bool MapWorker::isBusy() const
{
    if (outlines_.isBusy() || more_.isActive())
        return true;
    const std::lock_guard lock(mutex_);
    return busy_ || posted_ > 0 || next_.has_value();
}

void MapWorker::run(const std::stop_token& stop)
{
    while (true) {
        std::optional<MapRequest> request;
        {
            std::unique_lock lock(mutex_);
            if (!wake_.wait(lock, stop, [this] { return next_.has_value(); }))
                return;
            request = std::exchange(next_, std::nullopt);
            busy_ = true;
        }
        QStringList problems;
        std::shared_ptr<ShownMap> edited = withEdits(*request, problems);
        post([this, edited = std::move(edited), problems] { take(edited, problems); });
        const std::lock_guard lock(mutex_);
        busy_ = false;
    }
}

void MapWorker::post(std::function<void()> what)
{
    {
        const std::lock_guard lock(mutex_);
        ++posted_;
    }
    QMetaObject::invokeMethod(
        this,
        [this, what = std::move(what)] {
            what();
            const std::lock_guard lock(mutex_);
            --posted_;
        },
        Qt::QueuedConnection);
}

void MapWorker::take(std::shared_ptr<ShownMap> map, const QStringList& problems)
{
    std::vector<std::shared_ptr<const Plane>> planes;
    for (const ShownPlane& plane : map->planes)
        planes.push_back(plane.plane);
    outlines_.want(std::move(planes), map->snapshot);
    fill(*map);
    more_.stop();
    last_ = std::move(map);
    problems_ = problems;
    emit shown(last_, problems_);
}

void MapWorker::fill(ShownMap& map) const
{
    for (ShownPlane& plane : map.planes)
        plane.outline = outlines_.outlineOf(*plane.plane);
}

void MapWorker::showMore()
{
    if (!last_)
        return;
    auto map = std::make_shared<ShownMap>(*last_);
    fill(*map);
    last_ = std::move(map);
    emit shown(last_, problems_);
}

}  // namespace planewright
