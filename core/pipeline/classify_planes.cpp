// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/pipeline/classify_planes.h"

#include <algorithm>
#include <cmath>

#include "core/types/angle.h"

namespace planewright {

namespace {

constexpr double kTolerance = degrees(15.0);
constexpr double kSameHeight = 0.25;  // [m]
constexpr double kShareOfLargest = 0.2;

/// Mean height of a plane's points [m].
double heightOf(const Plane& plane, const SegmentLog& log)
{
    double sum = 0.0;
    double points = 0.0;
    for (const SegmentId& id : plane.segments) {
        const LineSegment& segment = log[id];
        sum += segment.points * segment.midpoint().z();
        points += segment.points;
    }
    return points > 0.0 ? sum / points : 0.0;
}

struct LevelPlane {
    std::size_t place = 0;
    double height = 0.0;  ///< beyond the laser, away from it [m]
    int points = 0;
};

/// Names the planes of one side that are at the outermost height.
void nameOutermost(const std::vector<LevelPlane>& planes, std::string_view name, std::vector<std::string_view>& classes)
{
    int largest = 0;
    for (const LevelPlane& plane : planes)
        largest = std::max(largest, plane.points);
    double outermost = 0.0;
    for (const LevelPlane& plane : planes) {
        if (plane.points >= kShareOfLargest * largest)
            outermost = std::max(outermost, plane.height);
    }
    for (const LevelPlane& plane : planes) {
        if (std::abs(plane.height - outermost) <= kSameHeight)
            classes[plane.place] = name;
    }
}

}  // namespace

std::vector<std::string_view> classesOf(const std::vector<std::shared_ptr<const Plane>>& planes, const SegmentLog& log)
{
    std::vector<std::string_view> classes(planes.size(), "other");
    std::vector<LevelPlane> below;
    std::vector<LevelPlane> above;
    for (std::size_t i = 0; i < planes.size(); ++i) {
        const double upright = std::abs(planes[i]->normal.z());
        if (upright <= std::sin(kTolerance))
            classes[i] = "wall";
        if (upright < std::cos(kTolerance))
            continue;
        const double height = heightOf(*planes[i], log);
        (height < 0.0 ? below : above).push_back({i, std::abs(height), planes[i]->points});
    }
    nameOutermost(below, "floor", classes);
    nameOutermost(above, "ceiling", classes);
    return classes;
}

}  // namespace planewright
