// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/view3d/place_handles.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <QPolygonF>

#include "ui/view3d/overlay_painter.h"

namespace planewright {

namespace {

constexpr double kHeightOverRadius = 0.6;  // of the arrow's tip
constexpr double kShallowest = 0.05;       // sine of the angle between a ray and what a handle moves on
constexpr int kRingCorners = 72;
constexpr double kHandlePixels = 7.0;

/// Where a ray meets the level of a height; nothing where it hardly does, or behind the eye.
std::optional<Eigen::Vector3d> onLevel(const Ray& ray, double height)
{
    if (std::abs(ray.direction.z()) < kShallowest)
        return std::nullopt;
    const double along = (height - ray.origin.z()) / ray.direction.z();
    return along > 0.0 ? std::optional<Eigen::Vector3d>(ray.at(along)) : std::nullopt;
}

/// The height on a vertical at which a ray comes nearest to it.
std::optional<double> heightOn(const Ray& ray, const Eigen::Vector3d& foot)
{
    const double level = ray.direction.head<2>().squaredNorm();
    if (level < kShallowest * kShallowest)
        return std::nullopt;
    const double along = (foot - ray.origin).head<2>().dot(ray.direction.head<2>()) / level;
    return along > 0.0 ? std::optional<double>(ray.at(along).z()) : std::nullopt;
}

/// Turns about the vertical through a place.
Pose turnAbout(const Eigen::Vector3d& place, double angle)
{
    const Eigen::Quaterniond turn(Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ()));
    return {turn, place - turn * place};
}

Eigen::Vector3d towards(double heading)
{
    return {std::cos(heading), std::sin(heading), 0.0};
}

double headingFrom(const Eigen::Vector3d& middle, const Eigen::Vector3d& place)
{
    return std::atan2(place.y() - middle.y(), place.x() - middle.x());
}

/// A line through points as it is seen; what is behind the eye is left out.
QPolygonF seenLine(const std::vector<Eigen::Vector3d>& points, const ViewCamera& camera, QSize size)
{
    QPolygonF line;
    for (const Eigen::Vector3d& point : points) {
        const Eigen::Vector3d at = projected(camera, point);
        if (at.z() > 0.0)
            line.append(toPixels(at, size));
    }
    return line;
}

std::vector<Eigen::Vector3d> circleOf(const PlacedShape& shape)
{
    std::vector<Eigen::Vector3d> corners;
    for (int i = 0; i <= kRingCorners; ++i) {
        corners.emplace_back(shape.middle + shape.radius * towards(2.0 * std::numbers::pi * i / kRingCorners));
    }
    return corners;
}

/// A handle as a sign of its own: a diamond, a disc, an arrow's head.
void paintHandle(QPainter& painter, PlaceHandle handle, const QPointF& at)
{
    const double r = kHandlePixels;
    switch (handle) {
        case PlaceHandle::Shift:
            painter.drawPolygon(
                QPolygonF{at + QPointF(0, -r), at + QPointF(r, 0), at + QPointF(0, r), at + QPointF(-r, 0)});
            return;
        case PlaceHandle::Turn:
            painter.drawEllipse(at, r, r);
            return;
        case PlaceHandle::Height:
            painter.drawPolygon(
                QPolygonF{at + QPointF(0, -1.4 * r), at + QPointF(r, 0.6 * r), at + QPointF(-r, 0.6 * r)});
            return;
    }
}

}  // namespace

PlacedShape moved(const PlacedShape& shape, const Pose& motion)
{
    PlacedShape there = shape;
    there.middle = motion * shape.middle;
    there.heading = headingFrom(Eigen::Vector3d::Zero(), motion.rotation * towards(shape.heading));
    for (std::vector<Eigen::Vector3d>& ring : there.rings) {
        for (Eigen::Vector3d& corner : ring)
            corner = motion * corner;
    }
    return there;
}

Eigen::Vector3d placeOf(PlaceHandle handle, const PlacedShape& shape)
{
    switch (handle) {
        case PlaceHandle::Shift:
            break;
        case PlaceHandle::Turn:
            return shape.middle + shape.radius * towards(shape.heading);
        case PlaceHandle::Height:
            return shape.middle + kHeightOverRadius * shape.radius * Eigen::Vector3d::UnitZ();
    }
    return shape.middle;
}

std::optional<PlaceHandle> PlaceHandles::at(const ViewCamera& camera, const Eigen::Vector2d& place,
                                            double tolerance) const
{
    if (!shape_)
        return std::nullopt;
    const Eigen::Vector3d middle = projected(camera, placeOf(PlaceHandle::Shift, *shape_));
    const double reach = tolerance;
    std::optional<PlaceHandle> nearest;
    for (const PlaceHandle handle : kPlaceHandles) {
        const Eigen::Vector3d seen = projected(camera, placeOf(handle, *shape_));
        // From above the arrow stands over the middle and could not be moved.
        if (handle == PlaceHandle::Height && (seen - middle).head<2>().norm() <= reach)
            continue;
        const double away = (seen.head<2>() - place).norm();
        if (seen.z() > 0.0 && away <= tolerance) {
            tolerance = away;
            nearest = handle;
        }
    }
    return nearest;
}

bool PlaceHandles::take(const ViewCamera& camera, const Eigen::Vector2d& place, double tolerance)
{
    held_ = at(camera, place, tolerance);
    if (held_)
        taken_ = *shape_;
    return held_.has_value();
}

std::optional<Pose> PlaceHandles::motionTo(const Ray& ray) const
{
    if (!held_)
        return std::nullopt;
    const Eigen::Vector3d from = placeOf(*held_, taken_);
    if (*held_ == PlaceHandle::Height) {
        const auto height = heightOn(ray, from);
        if (!height)
            return std::nullopt;
        return Pose{Eigen::Quaterniond::Identity(), (*height - from.z()) * Eigen::Vector3d::UnitZ()};
    }
    const auto to = onLevel(ray, from.z());
    if (!to)
        return std::nullopt;
    if (*held_ == PlaceHandle::Shift)
        return Pose{Eigen::Quaterniond::Identity(), *to - from};
    return turnAbout(taken_.middle, headingFrom(taken_.middle, *to) - headingFrom(taken_.middle, from));
}

void PlaceHandles::paint(QPainter& painter, QSize size, const ViewCamera& camera, Theme theme) const
{
    if (!shape_)
        return;
    const ThemeColours& colours = themeColours(theme);
    const QColor marked = toQColor(colours.selection);
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    QColor faint = marked;
    faint.setAlpha(130);
    painter.setPen(QPen(faint, 1.0));
    for (const std::vector<Eigen::Vector3d>& ring : shape_->rings)
        painter.drawPolygon(seenLine(ring, camera, size));
    painter.setPen(QPen(marked, 2.0));
    painter.drawPolyline(seenLine(circleOf(*shape_), camera, size));
    painter.drawPolyline(seenLine({shape_->middle, placeOf(PlaceHandle::Height, *shape_)}, camera, size));
    for (const PlaceHandle handle : kPlaceHandles) {
        const QPolygonF at = seenLine({placeOf(handle, *shape_)}, camera, size);
        if (at.isEmpty())
            continue;
        painter.setPen(QPen(toQColor(colours.background), 1.5));
        painter.setBrush(held_ == handle ? toQColor(colours.text) : marked);
        paintHandle(painter, handle, at.front());
    }
    painter.restore();
}

}  // namespace planewright
