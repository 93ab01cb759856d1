// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "core/types/error.h"

namespace planewright {

/// True label of a beam without return, of a mixed pixel, and of a return that belongs to no plane of the truth.
inline constexpr int kNoTruePlane = -1;
/// True label of a return from a surface that is no plane: a cylinder or other clutter.
inline constexpr int kNotPlanar = -2;

/// A plane that is known to be there: n·p = d with |n| = 1 and d ≥ 0, in the sensor's frame [m].
struct TruePlane {
    int id = kNoTruePlane;
    std::string name;  ///< what a person would call it: "left wall", "desk 1 top"
    Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
    double distance = 0.0;  ///< d [m]
};

/// A flat piece of surface: corner + a·edgeU + b·edgeV with a and b from 0 to 1, seen from both sides [m].
struct RectangleSurface {
    Eigen::Vector3d corner = Eigen::Vector3d::Zero();
    Eigen::Vector3d edgeU = Eigen::Vector3d::UnitX();
    Eigen::Vector3d edgeV = Eigen::Vector3d::UnitY();
    int plane = kNoTruePlane;  ///< id of the TruePlane it lies in; rectangles in one plane share it
    double dropout = 0.0;      ///< share of its returns that are lost, as on glass
};

/// A sector of a cylinder's mantle, seen from both sides [m].
struct CylinderSurface {
    Eigen::Vector3d base = Eigen::Vector3d::Zero();     ///< where the axis begins
    Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();    ///< from the base to the other end: its length is the height
    Eigen::Vector3d radius = Eigen::Vector3d::UnitX();  ///< at right angles to the axis, to where the sector begins
    double sweep = 0.0;                                 ///< angle of the sector, right-handed about the axis [rad]
};

/// A room of known planes about the sensor, which sits at the origin.
///
/// Frame: the sensor's at its pitch axis, x right, y forward, z up, metres.
struct Scene {
    std::string name;
    std::vector<RectangleSurface> rectangles;
    std::vector<CylinderSurface> cylinders;
    std::vector<TruePlane> planes;  ///< in order of id, from 0
};

/// The rooms that makeScene knows: corridor office hall curved stairs twelve clutter empty hostile.
std::span<const std::string_view> sceneNames();

/// A room by name; the seed varies dimensions, furniture and where the sensor stands. An unknown name is a Usage error
/// that lists the known ones.
///
/// | scene    | what it is                                                                              | planes |
/// | -------- | --------------------------------------------------------------------------------------- | ------ |
/// | corridor | 2.4 m × 30 m, doors recessed 5 to 10 cm on both sides: 4 planes a door                  | 6 + 4 × 16 to
/// 20 | | office   | about 6 m × 5 m with desks, cupboards, shelves, whiteboard and window niche             | 65 or 70
/// | | hall     | 20 m × 25 m with square pillars and partitions                                          | 35 to 37 |
/// | curved   | a room whose right wall curves gently                                                   | 14 |
/// | stairs   | a flight of 12 steps of 17 cm × 29 cm up to a landing                                   | 30 |
/// | twelve   | the planes of Table XII, id = number − 1, free-standing; the seed varies their extent   | 12 |
/// | clutter  | boxes at odd angles, leaning boards, drums, poles                                       | 79 to 99 |
/// | empty    | nothing at all                                                                          | 0 |
/// | hostile  | what is nasty: slats, grazing surfaces, planes 1 cm apart, glass, ranges at the limits  | 44 |
Result<Scene> makeScene(std::string_view name, std::uint64_t seed);

}  // namespace planewright
