// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>
#include <string>
#include <vector>

#include "ui/common/shown_map.h"

namespace planewright {

/// Makes maps by hand, so that every number in a table is known.
class MadeMap {
public:
    MadeMap() : map_(std::make_shared<ShownMap>()), snapshot_(std::make_shared<Snapshot>()) {}

    /// A slice with so many level segments of a metre, at y = 2 m, one above the other by 0.1 m a slice.
    MadeMap& slice(int count)
    {
        auto segments = std::make_shared<Segments>();
        const int step = map_->step + 1;
        for (int i = 0; i < count; ++i) {
            LineSegment line;
            line.id = {step, i};
            line.start = {2.0 * i, 2.0, 0.1 * step};
            line.end = {2.0 * i + 1.0, 2.0, 0.1 * step};
            line.points = 10;
            line.rms = 0.004;
            segments->push_back(line);
        }
        snapshot_->segments.append(step, segments);
        map_->step = step;
        return *this;
    }

    /// The plane y = 2 m of these segments.
    Plane wall(PlaneId id, std::vector<SegmentId> segments, std::uint64_t revision = 1) const
    {
        Plane plane;
        plane.id = id;
        plane.revision = revision;
        plane.normal = {0.0, 1.0, 0.0};
        plane.distance = 2.0;
        plane.fittingError = 0.5;
        plane.rms = 0.004;
        plane.segments = std::move(segments);
        plane.bornStep = 4;
        plane.changedStep = 9;
        return plane;
    }

    MadeMap& plane(Plane plane, const std::string& className = "wall", const std::string& name = {})
    {
        ShownPlane shown;
        shown.plane = std::make_shared<Plane>(std::move(plane));
        shown.className = className;
        shown.name = name;
        map_->planes.push_back(std::move(shown));
        return *this;
    }

    /// What the operator has made of the last plane.
    ShownPlane& last() { return map_->planes.back(); }

    /// Gives the last plane an outline of this area and size, without working one out.
    MadeMap& outlined(double area, double width, double height)
    {
        auto filled = std::make_shared<FilledOutline>();
        filled->revision = last().plane->revision;
        filled->outline.area = area;
        filled->outline.width = width;
        filled->outline.height = height;
        last().outline = std::move(filled);
        return *this;
    }

    MadeMap& cluster(ClusterId id, std::vector<SegmentId> segments)
    {
        auto cluster = std::make_shared<DirectionCluster>();
        cluster->id = id;
        cluster->segments = std::move(segments);
        snapshot_->clusters.push_back(std::move(cluster));
        return *this;
    }

    MadeMap& finished(int unfitted)
    {
        map_->finished = true;
        snapshot_->report.counts.unfitted = unfitted;
        return *this;
    }

    /// The map; what is made afterwards goes into another one that shares its segments.
    std::shared_ptr<const ShownMap> get()
    {
        auto map = std::make_shared<ShownMap>(*map_);
        auto snapshot = std::make_shared<Snapshot>(*snapshot_);
        for (const ShownPlane& shown : map->planes)
            snapshot->planes.push_back(shown.plane);
        map->snapshot = std::move(snapshot);
        return map;
    }

    MadeMap& withoutPlanes()
    {
        map_->planes.clear();
        return *this;
    }

private:
    std::shared_ptr<ShownMap> map_;
    std::shared_ptr<Snapshot> snapshot_;
};

}  // namespace planewright
