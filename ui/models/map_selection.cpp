// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/models/map_selection.h"

#include <algorithm>

namespace planewright {

namespace {

template <class Id>
std::set<Id> with(std::set<Id> ids, const Id& id)
{
    ids.insert(id);
    return ids;
}

template <class Id>
std::set<Id> toggled(std::set<Id> ids, const Id& id)
{
    if (ids.erase(id) == 0)
        ids.insert(id);
    return ids;
}

bool has(const ShownMap& map, PlaneId plane)
{
    return std::binary_search(map.planes.begin(), map.planes.end(), plane, [](const auto& a, const auto& b) {
        const auto id = [](const auto& value) {
            if constexpr (std::is_same_v<std::decay_t<decltype(value)>, PlaneId>)
                return value;
            else
                return value.plane->id;
        };
        return id(a) < id(b);
    });
}

bool has(const ShownMap& map, const SegmentId& segment)
{
    if (!map.snapshot)
        return false;
    const SegmentLog& log = map.snapshot->segments;
    const std::size_t slice = log.find(segment.step);
    return slice < log.slices() && segment.index >= 0 &&
           static_cast<std::size_t>(segment.index) < log.slice(slice).size();
}

}  // namespace

MapSelection::MapSelection(QObject* parent) : QObject(parent) {}

void MapSelection::select(std::set<PlaneId> planes, std::set<SegmentId> segments, std::set<BeamRun> pieces)
{
    if (planes == planes_ && segments == segments_ && pieces == pieces_)
        return;
    planes_ = std::move(planes);
    segments_ = std::move(segments);
    pieces_ = std::move(pieces);
    emit changed();
}

void MapSelection::addPlane(PlaneId plane)
{
    select(with(planes_, plane), segments_, pieces_);
}

void MapSelection::togglePlane(PlaneId plane)
{
    select(toggled(planes_, plane), segments_, pieces_);
}

void MapSelection::addSegment(const SegmentId& segment)
{
    select(planes_, with(segments_, segment), pieces_);
}

void MapSelection::toggleSegment(const SegmentId& segment)
{
    select(planes_, toggled(segments_, segment), pieces_);
}

void MapSelection::selectAll(const ShownMap& map)
{
    std::set<PlaneId> all;
    for (const ShownPlane& plane : map.planes) {
        if (!plane.hidden)
            all.insert(plane.plane->id);
    }
    select(std::move(all));
}

void MapSelection::invert(const ShownMap& map)
{
    std::set<PlaneId> others;
    for (const ShownPlane& plane : map.planes) {
        if (!plane.hidden && !planes_.contains(plane.plane->id))
            others.insert(plane.plane->id);
    }
    select(std::move(others));
}

void MapSelection::keepWhatIsIn(const ShownMap& map)
{
    std::set<PlaneId> planes = planes_;
    std::set<SegmentId> segments = segments_;
    std::erase_if(planes, [&](PlaneId plane) { return !has(map, plane); });
    std::erase_if(segments, [&](const SegmentId& segment) { return !has(map, segment); });
    std::set<BeamRun> pieces = pieces_;
    std::erase_if(pieces, [&](const BeamRun& piece) { return piece.step > map.step; });
    select(std::move(planes), std::move(segments), std::move(pieces));
    if (hovered_ != kNoPlane && !has(map, hovered_))
        hover(kNoPlane);
}

void MapSelection::hover(PlaneId plane)
{
    if (plane == hovered_)
        return;
    hovered_ = plane;
    emit hoverChanged(plane);
}

}  // namespace planewright
