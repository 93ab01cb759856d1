// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/formats/room_drawings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/formats/svg_drawing.h"
#include "core/geometry/cut_outline.h"
#include "core/types/plane_words.h"

namespace planewright {

namespace {

constexpr double kUprightBelow = 0.5;  // |nz| of a plane that is drawn as upright: 30° from it
constexpr double kFacing = 0.5;        // of a normal and the direction of sight: 60°

/// From space to a drawing: x to the right, y up.
struct Sight {
    Eigen::Vector3d right;
    Eigen::Vector3d up;

    Eigen::Vector2d operator()(const Eigen::Vector3d& point) const { return {right.dot(point), up.dot(point)}; }
};

std::string styleOf(const PlaneResult& plane, const std::string& kind)
{
    const std::string& name = plane.className;
    return (name == "floor" || name == "ceiling" || name == "wall" ? name : "other") + " " + kind;
}

std::vector<SvgDrawing::Ring> ringsOf(const Outline& outline, const Sight& sight)
{
    std::vector<SvgDrawing::Ring> rings;
    const auto add = [&](const std::vector<Eigen::Vector3d>& ring) {
        SvgDrawing::Ring drawn;
        drawn.reserve(ring.size());
        for (const Eigen::Vector3d& corner : ring)
            drawn.push_back(sight(corner));
        rings.push_back(std::move(drawn));
    };
    for (const Outline::Polygon& part : outline.parts) {
        add(part.ring);
        for (const auto& hole : part.holes)
            add(hole);
    }
    return rings;
}

/// What all these planes and the scanner cover in a drawing.
struct Extent {
    Eigen::Vector2d lowest = Eigen::Vector2d::Zero();
    Eigen::Vector2d highest = Eigen::Vector2d::Zero();
};

Extent extentOf(const std::vector<const PlaneResult*>& planes, const Sight& sight)
{
    Extent extent;
    for (const PlaneResult* plane : planes) {
        for (const SvgDrawing::Ring& ring : ringsOf(plane->outline, sight)) {
            for (const Eigen::Vector2d& corner : ring) {
                extent.lowest = extent.lowest.cwiseMin(corner);
                extent.highest = extent.highest.cwiseMax(corner);
            }
        }
    }
    return extent;
}

constexpr double kTallest = 640.0;  // picture [px]

void labelAll(SvgDrawing& drawing, std::vector<const PlaneResult*> planes, const Sight& sight)
{
    std::stable_sort(planes.begin(), planes.end(),
                     [](const auto* a, const auto* b) { return a->outline.area > b->outline.area; });
    for (const PlaneResult* plane : planes) {
        const std::string text = plane->name.empty() ? planeLabel(plane->plane->id) : plane->name;
        drawing.label("label", sight(plane->outline.centroid), text);
    }
}

std::string planOf(std::span<const PlaneResult> planes, const Sight& sight, double cutHeight, double width)
{
    std::vector<const PlaneResult*> all;
    std::vector<const PlaneResult*> level;
    std::vector<const PlaneResult*> upright;
    for (const PlaneResult& plane : planes) {
        all.push_back(&plane);
        (std::abs(plane.plane->normal.z()) < kUprightBelow ? upright : level).push_back(&plane);
    }
    // The lowest first: what is above hides it.
    std::stable_sort(level.begin(), level.end(),
                     [](const auto* a, const auto* b) { return a->outline.centroid.z() < b->outline.centroid.z(); });
    const Extent extent = extentOf(all, sight);
    SvgDrawing drawing{extent.lowest, extent.highest, width, kTallest};
    drawing.grid();
    for (const PlaneResult* plane : level)
        drawing.area(styleOf(*plane, "area"), ringsOf(plane->outline, sight));
    for (const PlaneResult* plane : upright) {
        drawing.area(styleOf(*plane, "edge"), ringsOf(plane->outline, sight));
        for (const PlanLine& line : cutAtHeight(plane->outline, plane->plane->normal, cutHeight))
            drawing.line(styleOf(*plane, "cut"), sight({line.from.x(), line.from.y(), cutHeight}),
                         sight({line.to.x(), line.to.y(), cutHeight}));
    }
    drawing.dot("scanner", sight(Eigen::Vector3d::Zero()), 4.0);
    labelAll(drawing, upright, sight);
    return std::move(drawing).take("Plan");
}

/// Empty where nothing faces the scanner on that side. `ahead`: the direction of sight, level, unit length.
std::string elevationOf(std::span<const PlaneResult> planes, const Eigen::Vector3d& ahead, double width,
                        const std::string& title)
{
    const Sight sight{Eigen::Vector3d{ahead.y(), -ahead.x(), 0.0}, Eigen::Vector3d::UnitZ()};
    std::vector<const PlaneResult*> all;
    std::vector<const PlaneResult*> facing;
    for (const PlaneResult& plane : planes) {
        all.push_back(&plane);
        if (std::abs(plane.plane->normal.dot(ahead)) > kFacing && plane.outline.centroid.dot(ahead) > 0.0)
            facing.push_back(&plane);
    }
    if (facing.empty())
        return {};
    std::stable_sort(facing.begin(), facing.end(), [&](const auto* a, const auto* b) {
        return a->outline.centroid.dot(ahead) > b->outline.centroid.dot(ahead);
    });
    const Extent extent = extentOf(all, sight);
    SvgDrawing drawing{extent.lowest, extent.highest, width, kTallest};
    drawing.grid();
    for (const PlaneResult* plane : all) {
        if (std::abs(plane->plane->normal.dot(ahead)) <= kFacing)
            drawing.area(styleOf(*plane, "edge"), ringsOf(plane->outline, sight));
    }
    for (const PlaneResult* plane : facing)
        drawing.area(styleOf(*plane, "area"), ringsOf(plane->outline, sight));
    drawing.dot("scanner", sight(Eigen::Vector3d::Zero()), 4.0);
    labelAll(drawing, facing, sight);
    return std::move(drawing).take(title);
}

}  // namespace

Eigen::Vector2d squaredDirection(std::span<const PlaneResult> planes)
{
    const PlaneResult* largest = nullptr;
    for (const PlaneResult& plane : planes) {
        const bool isUpright = std::abs(plane.plane->normal.z()) < kUprightBelow;
        if (isUpright && (largest == nullptr || plane.outline.area > largest->outline.area))
            largest = &plane;
    }
    if (largest == nullptr)
        return Eigen::Vector2d::UnitY();
    Eigen::Vector2d direction = largest->plane->normal.head<2>().normalized();
    const auto quarterTurn = [](const Eigen::Vector2d& v) { return Eigen::Vector2d{-v.y(), v.x()}; };
    Eigen::Vector2d nearest = direction;
    for (int turn = 0; turn < 3; ++turn) {
        direction = quarterTurn(direction);
        if (direction.y() > nearest.y())
            nearest = direction;
    }
    return nearest;
}

std::vector<RoomDrawing> roomDrawings(std::span<const PlaneResult> planes, double cutHeight, double width)
{
    std::vector<RoomDrawing> drawings;
    const Eigen::Vector2d squared = squaredDirection(planes);
    const Eigen::Vector3d forward{squared.x(), squared.y(), 0.0};
    const Eigen::Vector3d right{squared.y(), -squared.x(), 0.0};
    drawings.push_back({"Plan", planOf(planes, {right, forward}, cutHeight, width)});
    const std::array<std::pair<const char*, Eigen::Vector3d>, 4> sides{
        {{"Front", forward}, {"Right", right}, {"Back", -forward}, {"Left", -right}}};
    for (const auto& [title, ahead] : sides) {
        if (std::string svg = elevationOf(planes, ahead, width, title); !svg.empty())
            drawings.push_back({title, std::move(svg)});
    }
    return drawings;
}

}  // namespace planewright
