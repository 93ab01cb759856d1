// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <optional>
#include <vector>

#include <QPainter>
#include <QSize>

#include "core/geometry/pose.h"
#include "ui/common/palette.h"
#include "ui/scene/camera_motion.h"

namespace planewright {

/// What somebody takes hold of to place something: the middle shifts it in the level, the knob on the ring turns it
/// about the vertical, the arrow raises and lowers it.
enum class PlaceHandle { Shift, Turn, Height };
inline constexpr std::array kPlaceHandles{PlaceHandle::Shift, PlaceHandle::Turn, PlaceHandle::Height};

/// Something that is being placed, as it stands now.
struct PlacedShape {
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();  ///< of its ring [m]
    double radius = 1.0;                               ///< of its ring [m]
    double heading = 0.0;                              ///< of the knob on the ring, from x towards y [rad]
    std::vector<std::vector<Eigen::Vector3d>> rings;   ///< outlines that go with it [m]
};

/// The shape after a turn about the vertical and a shift.
PlacedShape moved(const PlacedShape& shape, const Pose& motion);

/// Where a handle is [m].
Eigen::Vector3d placeOf(PlaceHandle handle, const PlacedShape& shape);

/// The handles of what is being placed, and which of them somebody has hold of.
class PlaceHandles {
public:
    void setShape(const std::optional<PlacedShape>& shape) { shape_ = shape; }
    const std::optional<PlacedShape>& shape() const { return shape_; }
    std::optional<PlaceHandle> held() const { return held_; }

    /// Takes hold of the nearest handle to a place of the picture, given as for zoomed(), within a tolerance in
    /// fractions of the picture's height; false where there is none.
    bool take(const ViewCamera& camera, const Eigen::Vector2d& place, double tolerance);
    void letGo() { held_.reset(); }

    /// How the shape moves, since the handle was taken, to bring it under a line of sight; nothing where that looks
    /// along what the handle moves on, as the height does from above.
    std::optional<Pose> motionTo(const Ray& ray) const;

    /// Draws shape and handles over a picture of this size.
    void paint(QPainter& painter, QSize size, const ViewCamera& camera, Theme theme) const;

private:
    std::optional<PlaceHandle> at(const ViewCamera& camera, const Eigen::Vector2d& place, double tolerance) const;

    std::optional<PlacedShape> shape_;
    PlacedShape taken_;  // the shape when the handle was taken
    std::optional<PlaceHandle> held_;
};

}  // namespace planewright
