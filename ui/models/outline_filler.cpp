// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/models/outline_filler.h"

#include <algorithm>

#include <QDeadlineTimer>

#include "ui/common/same_scan.h"

namespace planewright {

namespace {
constexpr std::chrono::milliseconds kRest{10};  // between two spells of work: the window is drawn meanwhile
}

OutlineFiller::OutlineFiller(QObject* parent) : QObject(parent), timer_(this)
{
    timer_.setInterval(kRest);
    connect(&timer_, &QTimer::timeout, this, &OutlineFiller::work);
}

void OutlineFiller::setMap(const std::shared_ptr<const ShownMap>& map)
{
    if (!map || !map_ || !isSameScan(*map, *map_))
        outlines_.clear();
    map_ = map;
    next_ = 0;
    publish();
    const bool open = map_ && std::any_of(map_->planes.begin(), map_->planes.end(),
                                          [this](const ShownPlane& plane) { return isOpen(plane); });
    if (open && !timer_.isActive())
        timer_.start();
    else if (!open)
        timer_.stop();
}

bool OutlineFiller::isOpen(const ShownPlane& plane) const
{
    if (plane.outline && plane.outline->revision == plane.plane->revision)
        return false;
    const auto known = outlines_.find(plane.plane->id);
    return known == outlines_.end() || known->second->revision != plane.plane->revision;
}

void OutlineFiller::work()
{
    const QDeadlineTimer deadline(budget_);
    for (; next_ < map_->planes.size() && !deadline.hasExpired(); ++next_) {
        const ShownPlane& plane = map_->planes[next_];
        if (isOpen(plane))
            outlines_[plane.plane->id] = filledOutlineOf(*plane.plane, map_->snapshot->segments);
    }
    if (next_ == map_->planes.size())
        timer_.stop();
    publish();
}

void OutlineFiller::publish()
{
    if (!map_) {
        emit filled(map_);
        return;
    }
    auto map = std::make_shared<ShownMap>(*map_);
    for (ShownPlane& plane : map->planes) {
        const auto known = outlines_.find(plane.plane->id);
        if (known != outlines_.end() && (!plane.outline || plane.outline->revision != plane.plane->revision))
            plane.outline = known->second;
    }
    emit filled(map);
}

}  // namespace planewright
