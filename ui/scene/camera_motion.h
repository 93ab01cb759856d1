// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vtkCamera.h>

#include <Eigen/Geometry>

#include "core/geometry/picking.h"

namespace planewright {

/// Where one looks from, as a turntable with z up.
struct ViewCamera {
    Eigen::Vector3d target = Eigen::Vector3d::Zero();  ///< what the camera turns about [m]
    double distance = 10.0;                            ///< from the target [m]
    double heading = 0.0;    ///< direction of view in the ground plane, from y (forward) towards −x [rad]
    double elevation = 0.5;  ///< how far the camera looks down [rad]; π/2 from above
    double viewAngle = 0.6;  ///< of the picture's height [rad]
    bool parallel = false;

    /// Unit vectors of the picture in space.
    Eigen::Vector3d forward() const;
    Eigen::Vector3d right() const;
    Eigen::Vector3d up() const;
    Eigen::Vector3d eye() const { return target - distance * forward(); }

    /// Height of the picture at the target [m].
    double heightAtTarget() const;

    friend bool operator==(const ViewCamera&, const ViewCamera&) = default;
};

/// Views with a name.
enum class NamedView { Top, Front, Side, Iso, Sensor };

/// The camera of a named view that shows all of a box in a picture of this width over height. An empty box is taken for
/// a room of 8 m.
ViewCamera namedView(NamedView view, const Eigen::AlignedBox3d& bounds, double aspect, const ViewCamera& before);

/// The same direction of view, all of the box in the picture.
ViewCamera fitted(const ViewCamera& camera, const Eigen::AlignedBox3d& bounds, double aspect);

/// Turns about the target by a drag, in fractions of the picture's height.
ViewCamera rotated(const ViewCamera& camera, double right, double down);

/// Shifts the scene under the pointer, in fractions of the picture's height.
ViewCamera panned(const ViewCamera& camera, double right, double down);

/// Comes nearer (factor below 1) or goes away, so that what is under the pointer stays there. The pointer is given from
/// the middle of the picture, in fractions of its height, right and up.
ViewCamera zoomed(const ViewCamera& camera, double factor, double pointerRight, double pointerUp);

/// Walks: metres to the right, forward and up.
ViewCamera walked(const ViewCamera& camera, double right, double ahead, double up);

/// Turns about a point by a drag: the point stays where it is in the picture.
ViewCamera rotatedAbout(const ViewCamera& camera, const Eigen::Vector3d& pivot, double right, double down);

/// Looks at a point from the same direction and distance.
ViewCamera centredOn(const ViewCamera& camera, const Eigen::Vector3d& point);

/// The line of sight through a place of the picture, given as for zoomed().
Ray rayThrough(const ViewCamera& camera, double right, double up);

/// Where a point appears, given as for zoomed(), and its depth [m]; negative behind the camera.
Eigen::Vector3d projected(const ViewCamera& camera, const Eigen::Vector3d& point);

/// Sets up VTK's camera, with clipping planes around a sphere that holds the scene.
void apply(const ViewCamera& camera, const Eigen::AlignedBox3d& bounds, vtkCamera* vtk);

}  // namespace planewright
