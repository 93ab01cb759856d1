// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/scene/camera_motion.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/types/angle.h"

namespace planewright {

namespace {

constexpr double kMostElevation = std::numbers::pi / 2.0;
constexpr double kTurn = std::numbers::pi;  // [rad] for a drag over the height of the picture
constexpr double kNearest = 0.05;           // [m]
constexpr double kFarthest = 5000.0;        // [m]
constexpr double kMargin = 1.05;

Eigen::AlignedBox3d roomOf(const Eigen::AlignedBox3d& bounds)
{
    if (!bounds.isEmpty())
        return bounds;
    return {Eigen::Vector3d{-4.0, -4.0, -1.5}, Eigen::Vector3d{4.0, 4.0, 1.5}};
}

}  // namespace

Eigen::Vector3d ViewCamera::forward() const
{
    return {-std::sin(heading) * std::cos(elevation), std::cos(heading) * std::cos(elevation), -std::sin(elevation)};
}

Eigen::Vector3d ViewCamera::right() const
{
    return {std::cos(heading), std::sin(heading), 0.0};
}

Eigen::Vector3d ViewCamera::up() const
{
    return right().cross(forward());
}

double ViewCamera::heightAtTarget() const
{
    return 2.0 * distance * std::tan(viewAngle / 2.0);
}

ViewCamera fitted(const ViewCamera& camera, const Eigen::AlignedBox3d& bounds, double aspect)
{
    const Eigen::AlignedBox3d room = roomOf(bounds);
    ViewCamera result = camera;
    result.target = room.center();
    const double tangent = std::tan(camera.viewAngle / 2.0);
    double distance = kNearest;
    for (int i = 0; i < 8; ++i) {
        const Eigen::Vector3d corner = room.corner(static_cast<Eigen::AlignedBox3d::CornerType>(i)) - result.target;
        const double needed =
            std::max(std::abs(corner.dot(camera.right())) / aspect, std::abs(corner.dot(camera.up()))) / tangent;
        const double nearer = camera.parallel ? 0.0 : -corner.dot(camera.forward());
        distance = std::max(distance, kMargin * needed + nearer);
    }
    result.distance = std::clamp(distance, kNearest, kFarthest);
    return result;
}

ViewCamera namedView(NamedView view, const Eigen::AlignedBox3d& bounds, double aspect, const ViewCamera& before)
{
    ViewCamera camera = before;
    camera.heading = 0.0;
    switch (view) {
        case NamedView::Top:
            camera.elevation = kMostElevation;
            break;
        case NamedView::Front:
            camera.elevation = 0.0;
            break;
        case NamedView::Side:
            camera.elevation = 0.0;
            camera.heading = std::numbers::pi / 2.0;
            break;
        case NamedView::Iso:
            camera.heading = degrees(-35.0);
            camera.elevation = degrees(35.0);
            break;
        case NamedView::Sensor:
            camera.elevation = degrees(5.0);
            camera.target = {0.0, 2.0, 0.0};
            camera.distance = 2.0;
            camera.parallel = false;
            return camera;
    }
    return fitted(camera, bounds, aspect);
}

ViewCamera rotated(const ViewCamera& camera, double right, double down)
{
    ViewCamera result = camera;
    result.heading = std::remainder(camera.heading - kTurn * right, 2.0 * std::numbers::pi);
    result.elevation = std::clamp(camera.elevation + kTurn * down, -kMostElevation, kMostElevation);
    return result;
}

ViewCamera panned(const ViewCamera& camera, double right, double down)
{
    ViewCamera result = camera;
    const double height = camera.heightAtTarget();
    result.target += height * (down * camera.up() - right * camera.right());
    return result;
}

ViewCamera zoomed(const ViewCamera& camera, double factor, double pointerRight, double pointerUp)
{
    ViewCamera result = camera;
    result.distance = std::clamp(camera.distance * factor, kNearest, kFarthest);
    const double moved = camera.heightAtTarget() - result.heightAtTarget();
    result.target += moved * (pointerRight * camera.right() + pointerUp * camera.up());
    return result;
}

ViewCamera walked(const ViewCamera& camera, double right, double ahead, double up)
{
    ViewCamera result = camera;
    const Eigen::Vector3d level{-std::sin(camera.heading), std::cos(camera.heading), 0.0};
    result.target += right * camera.right() + ahead * level + up * Eigen::Vector3d::UnitZ();
    return result;
}

ViewCamera rotatedAbout(const ViewCamera& camera, const Eigen::Vector3d& pivot, double right, double down)
{
    const Eigen::Vector3d offset = camera.target - pivot;
    ViewCamera result = rotated(camera, right, down);
    result.target = pivot + offset.dot(camera.right()) * result.right() + offset.dot(camera.up()) * result.up() +
                    offset.dot(camera.forward()) * result.forward();
    return result;
}

ViewCamera centredOn(const ViewCamera& camera, const Eigen::Vector3d& point)
{
    ViewCamera result = camera;
    result.target = point;
    return result;
}

Ray rayThrough(const ViewCamera& camera, double right, double up)
{
    const Eigen::Vector3d onTarget =
        camera.target + camera.heightAtTarget() * (right * camera.right() + up * camera.up());
    if (camera.parallel)
        return {onTarget - kFarthest * camera.forward(), camera.forward()};
    return {camera.eye(), (onTarget - camera.eye()).normalized()};
}

Eigen::Vector3d projected(const ViewCamera& camera, const Eigen::Vector3d& point)
{
    const Eigen::Vector3d offset = point - camera.eye();
    const double depth = offset.dot(camera.forward());
    const double height = camera.parallel ? camera.heightAtTarget() : 2.0 * depth * std::tan(camera.viewAngle / 2.0);
    if (height == 0.0)
        return {0.0, 0.0, -1.0};
    return {offset.dot(camera.right()) / height, offset.dot(camera.up()) / height, depth};
}

void apply(const ViewCamera& camera, const Eigen::AlignedBox3d& bounds, vtkCamera* vtk)
{
    const Eigen::AlignedBox3d room = roomOf(bounds);
    const double radius = 0.5 * room.diagonal().norm() + 2.0;
    const double middle = (room.center() - camera.eye()).dot(camera.forward());
    const double farPlane = std::max(middle + radius, 2.0 * kNearest);
    const double nearPlane =
        camera.parallel ? middle - radius : std::max({middle - radius, farPlane * 1e-3, 0.2 * kNearest});
    const Eigen::Vector3d eye = camera.eye();
    const Eigen::Vector3d up = camera.up();
    vtk->SetPosition(eye.x(), eye.y(), eye.z());
    vtk->SetFocalPoint(camera.target.x(), camera.target.y(), camera.target.z());
    vtk->SetViewUp(up.x(), up.y(), up.z());
    vtk->SetViewAngle(toDegrees(camera.viewAngle));
    vtk->SetParallelProjection(camera.parallel);
    vtk->SetParallelScale(camera.heightAtTarget() / 2.0);
    vtk->SetClippingRange(nearPlane, farPlane);
}

}  // namespace planewright
