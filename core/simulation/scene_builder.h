// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/geometry/pose.h"
#include "core/simulation/scene.h"

namespace planewright {

/// Where the sensor stands in a room: its pitch axis' middle [m], and the turn of its gaze to the left [rad].
struct SensorPose {
    Eigen::Vector3d position = Eigen::Vector3d::Zero();
    double yaw = 0.0;
};

/// A vertical wall as a plan shows it: whoever walks from `from` to `to` has the room on the left [m].
struct WallPlan {
    Eigen::Vector2d from;
    Eigen::Vector2d to;
    double bottom;
    double top;
};

/// A rectangular hole in a wall: how far along it from its beginning, and how high [m].
struct Opening {
    double from;
    double to;
    double bottom;
    double top;
};

/// A box that stands upright: its front looks towards −y when it is not turned [m, rad].
struct BoxPlan {
    Eigen::Vector2d centre;
    Eigen::Vector3d size;  ///< width (x), depth (y), height
    double bottom = 0.0;
    double yaw = 0.0;
};

/// Faces of a box, to be joined by |. Those that touch a floor or wall are left out: nobody can see them.
enum BoxFace : unsigned { kLeft = 1, kRight = 2, kFront = 4, kBack = 8, kTop = 16, kBottom = 32 };
inline constexpr unsigned kStanding = kLeft | kRight | kFront | kBack | kTop;
inline constexpr unsigned kAgainstWall = kLeft | kRight | kFront | kTop;
inline constexpr unsigned kHungOnWall = kAgainstWall | kBottom;

/// Furnishes a room in the room's own frame: x right, y forward, z up, metres.
///
/// Every verb that takes a name makes one plane, or one per face, and gives back the id of the first.
class SceneBuilder {
public:
    explicit SceneBuilder(std::string name);

    /// A plane that consists of one rectangle so far.
    int rectangle(std::string name, const Eigen::Vector3d& corner, const Eigen::Vector3d& edgeU,
                  const Eigen::Vector3d& edgeV);

    /// One more rectangle in a plane; it must lie in it.
    void extend(int plane, const Eigen::Vector3d& corner, const Eigen::Vector3d& edgeU, const Eigen::Vector3d& edgeV);

    /// A horizontal rectangle between two corners of the plan: floor, ceiling, shelf, table top.
    int level(std::string name, double height, const Eigen::Vector2d& from, const Eigen::Vector2d& to);

    /// A wall, cut into rectangles about its openings, which must not overlap.
    int wall(const std::string& name, const WallPlan& plan, std::vector<Opening> openings = {});

    /// What fills an opening some way behind its wall: a leaf, two jambs, a lintel, and a sill where the opening begins
    /// above the wall's bottom.
    int recess(const std::string& name, const WallPlan& plan, const Opening& opening, double depth);

    int box(const std::string& name, const BoxPlan& plan, unsigned faces = kStanding);

    /// Makes the rectangles of a plane lose a share of their returns, as glass does.
    void makeGlass(int plane, double dropout);

    /// A sector of a cylinder (see CylinderSurface).
    void cylinder(const Eigen::Vector3d& base, const Eigen::Vector3d& axis, const Eigen::Vector3d& radius,
                  double sweep);

    /// A full cylinder from its base, along its axis.
    void pole(const Eigen::Vector3d& base, const Eigen::Vector3d& axis, double radius);

    /// The room as a sensor in it sees it.
    Scene build(const SensorPose& pose) const;
    Scene buildAt(const Pose& pose) const;

private:
    Scene seenFrom(const Eigen::Vector3d& position, const Eigen::Matrix3d& turn) const;

    Scene room_;
};

}  // namespace planewright
