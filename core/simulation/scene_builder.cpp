// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/simulation/scene_builder.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>
#include <utility>

#include <Eigen/Geometry>

#include "core/types/plane.h"

namespace planewright {

namespace {

Eigen::Vector3d raised(const Eigen::Vector2d& point, double height)
{
    return {point.x(), point.y(), height};
}

Eigen::Vector2d directionOf(const WallPlan& plan)
{
    return (plan.to - plan.from).normalized();
}

}  // namespace

SceneBuilder::SceneBuilder(std::string name)
{
    room_.name = std::move(name);
}

int SceneBuilder::rectangle(std::string name, const Eigen::Vector3d& corner, const Eigen::Vector3d& edgeU,
                            const Eigen::Vector3d& edgeV)
{
    TruePlane plane;
    plane.id = static_cast<int>(room_.planes.size());
    plane.name = std::move(name);
    plane.normal = edgeU.cross(edgeV).normalized();
    plane.distance = plane.normal.dot(corner);
    room_.planes.push_back(plane);
    extend(plane.id, corner, edgeU, edgeV);
    return plane.id;
}

void SceneBuilder::extend(int plane, const Eigen::Vector3d& corner, const Eigen::Vector3d& edgeU,
                          const Eigen::Vector3d& edgeV)
{
    [[maybe_unused]] const TruePlane& truth = room_.planes[static_cast<std::size_t>(plane)];
    assert(std::abs(truth.normal.dot(corner) - truth.distance) < 1e-9);
    room_.rectangles.push_back({corner, edgeU, edgeV, plane, 0.0});
}

int SceneBuilder::level(std::string name, double height, const Eigen::Vector2d& from, const Eigen::Vector2d& to)
{
    return rectangle(std::move(name), raised(from, height), {to.x() - from.x(), 0.0, 0.0},
                     {0.0, to.y() - from.y(), 0.0});
}

int SceneBuilder::wall(const std::string& name, const WallPlan& plan, std::vector<Opening> openings)
{
    std::sort(openings.begin(), openings.end(), [](const Opening& a, const Opening& b) { return a.from < b.from; });
    const Eigen::Vector2d along = directionOf(plan);
    int plane = kNoTruePlane;
    const auto piece = [&](double from, double to, double bottom, double top) {
        if (to - from < 1e-9 || top - bottom < 1e-9)
            return;
        const Eigen::Vector3d corner = raised(plan.from + from * along, bottom);
        const Eigen::Vector3d u = raised((to - from) * along, 0.0);
        const Eigen::Vector3d v(0.0, 0.0, top - bottom);
        if (plane == kNoTruePlane)
            plane = rectangle(name, corner, u, v);
        else
            extend(plane, corner, u, v);
    };

    double done = 0.0;
    for (const Opening& opening : openings) {
        piece(done, opening.from, plan.bottom, plan.top);
        piece(opening.from, opening.to, plan.bottom, opening.bottom);
        piece(opening.from, opening.to, opening.top, plan.top);
        done = opening.to;
    }
    piece(done, (plan.to - plan.from).norm(), plan.bottom, plan.top);
    return plane;
}

int SceneBuilder::recess(const std::string& name, const WallPlan& plan, const Opening& opening, double depth)
{
    const Eigen::Vector2d along = directionOf(plan);
    const Eigen::Vector2d outwards(along.y(), -along.x());
    const Eigen::Vector3d near = raised(plan.from + opening.from * along, opening.bottom);
    const Eigen::Vector3d width = raised((opening.to - opening.from) * along, 0.0);
    const Eigen::Vector3d height(0.0, 0.0, opening.top - opening.bottom);
    const Eigen::Vector3d back = raised(depth * outwards, 0.0);

    const int leaf = rectangle(name, near + back, width, height);
    rectangle(name + " jamb 1", near, back, height);
    rectangle(name + " jamb 2", near + width, back, height);
    rectangle(name + " lintel", near + height, width, back);
    if (opening.bottom > plan.bottom)
        rectangle(name + " sill", near, width, back);
    return leaf;
}

int SceneBuilder::box(const std::string& name, const BoxPlan& plan, unsigned faces)
{
    const Eigen::Rotation2Dd turn(plan.yaw);
    const Eigen::Vector3d width = raised(turn * Eigen::Vector2d(plan.size.x(), 0.0), 0.0);
    const Eigen::Vector3d depth = raised(turn * Eigen::Vector2d(0.0, plan.size.y()), 0.0);
    const Eigen::Vector3d height(0.0, 0.0, plan.size.z());
    const Eigen::Vector3d corner = raised(plan.centre, plan.bottom) - 0.5 * width - 0.5 * depth;

    const int first = static_cast<int>(room_.planes.size());
    if ((faces & kLeft) != 0)
        rectangle(name + " left", corner, depth, height);
    if ((faces & kRight) != 0)
        rectangle(name + " right", corner + width, depth, height);
    if ((faces & kFront) != 0)
        rectangle(name + " front", corner, width, height);
    if ((faces & kBack) != 0)
        rectangle(name + " back", corner + depth, width, height);
    if ((faces & kTop) != 0)
        rectangle(name + " top", corner + height, width, depth);
    if ((faces & kBottom) != 0)
        rectangle(name + " bottom", corner, width, depth);
    return first;
}

void SceneBuilder::makeGlass(int plane, double dropout)
{
    for (RectangleSurface& rectangle : room_.rectangles)
        if (rectangle.plane == plane)
            rectangle.dropout = dropout;
}

void SceneBuilder::cylinder(const Eigen::Vector3d& base, const Eigen::Vector3d& axis, const Eigen::Vector3d& radius,
                            double sweep)
{
    assert(std::abs(axis.dot(radius)) < 1e-9);
    room_.cylinders.push_back({base, axis, radius, sweep});
}

void SceneBuilder::pole(const Eigen::Vector3d& base, const Eigen::Vector3d& axis, double radius)
{
    cylinder(base, axis, radius * axis.unitOrthogonal(), 2.0 * std::numbers::pi);
}

Scene SceneBuilder::build(const SensorPose& pose) const
{
    return seenFrom(pose.position, Eigen::AngleAxisd(-pose.yaw, Eigen::Vector3d::UnitZ()).toRotationMatrix());
}

Scene SceneBuilder::buildAt(const Pose& pose) const
{
    return seenFrom(pose.translation, pose.rotation.conjugate().toRotationMatrix());
}

Scene SceneBuilder::seenFrom(const Eigen::Vector3d& position, const Eigen::Matrix3d& turn) const
{
    Scene scene = room_;
    for (RectangleSurface& r : scene.rectangles) {
        r.corner = turn * (r.corner - position);
        r.edgeU = turn * r.edgeU;
        r.edgeV = turn * r.edgeV;
    }
    for (CylinderSurface& c : scene.cylinders) {
        c.base = turn * (c.base - position);
        c.axis = turn * c.axis;
        c.radius = turn * c.radius;
    }
    for (TruePlane& plane : scene.planes) {
        plane.distance -= plane.normal.dot(position);
        plane.normal = turn * plane.normal;
        makeCanonical(plane.normal, plane.distance);
    }
    return scene;
}

}  // namespace planewright
