// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/window/map_worker.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "core/pipeline/apply_edits.h"

namespace planewright {

namespace {

/// A map with some outlines is shown after this time, while the rest are still worked out.
constexpr std::chrono::milliseconds kShowAfter{60};

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

MapWorker::MapWorker(QObject* parent) : QObject(parent), thread_([this](const std::stop_token& stop) { run(stop); }) {}

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
    const std::lock_guard lock(mutex_);
    return busy_ || next_.has_value();
}

bool MapWorker::isSuperseded() const
{
    const std::lock_guard lock(mutex_);
    return next_.has_value() || thread_.get_stop_token().stop_requested();
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
        work(*request);
        const std::lock_guard lock(mutex_);
        busy_ = false;
    }
}

void MapWorker::work(const MapRequest& request)
{
    QStringList problems;
    const std::shared_ptr<ShownMap> edited = withEdits(request, problems);
    if (!edited->snapshot) {
        known_.clear();
        lastOfId_.clear();
    }
    for (bool whole = false; !whole;) {
        auto map = std::make_shared<ShownMap>(*edited);
        whole = !map->snapshot || fillOutlines(*map, *map->snapshot);
        publish(std::move(map), problems);
        if (isSuperseded())
            return;
    }
}

/// Gives planes the outlines that are known, and works out others until it is time to show something. True where none
/// is left.
bool MapWorker::fillOutlines(ShownMap& map, const Snapshot& snapshot)
{
    std::unordered_map<const Plane*, Known> kept;
    std::vector<ShownPlane*> open;
    for (ShownPlane& plane : map.planes) {
        if (const auto found = known_.find(plane.plane.get()); found != known_.end()) {
            plane.outline = found->second.outline;
            kept.insert(*found);
            continue;
        }
        if (const auto last = lastOfId_.find(plane.plane->id); last != lastOfId_.end())
            plane.outline = last->second;
        open.push_back(&plane);
    }
    known_ = std::move(kept);
    // Those without any outline first, then those whose outline is oldest.
    std::stable_sort(open.begin(), open.end(), [](const ShownPlane* a, const ShownPlane* b) {
        const auto age = [](const ShownPlane& plane) { return plane.outline ? plane.outline->revision : 0; };
        return age(*a) < age(*b);
    });

    const auto begun = std::chrono::steady_clock::now();
    for (std::size_t i = 0; i < open.size(); ++i) {
        if (i > 0 && std::chrono::steady_clock::now() - begun > kShowAfter)
            return false;
        ShownPlane& plane = *open[i];
        plane.outline = filledOutlineOf(*plane.plane, snapshot.segments);
        known_[plane.plane.get()] = {plane.plane, plane.outline};
        lastOfId_[plane.plane->id] = plane.outline;
    }
    return true;
}

void MapWorker::publish(std::shared_ptr<const ShownMap> map, QStringList problems)
{
    QMetaObject::invokeMethod(
        this, [this, map = std::move(map), problems = std::move(problems)] { emit shown(map, problems); },
        Qt::QueuedConnection);
}

}  // namespace planewright
