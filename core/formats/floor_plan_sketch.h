// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include "core/formats/plane_result.h"

namespace planewright {

/// A place where the scanner stood, seen from above [m], and its number.
struct PlanStop {
    Eigen::Vector2d place;
    int number = 0;
};

/// A plan as lines, before it is drawn on paper or a screen: squared to its walls, right and up [m].
struct FloorPlanSketch {
    /// A stretch in which an outline crosses the height.
    struct Line {
        bool isWall = false;
        Eigen::Vector2d from;
        Eigen::Vector2d to;
    };
    std::vector<Line> lines;
    std::vector<PlanStop> stops;
    Eigen::Vector2d lowest = Eigen::Vector2d::Zero();  ///< of lines, stops and the frame's origin
    Eigen::Vector2d highest = Eigen::Vector2d::Zero();
};

/// Cuts outlines at a height [m]; stops are given in the frame of the planes.
FloorPlanSketch floorPlanSketch(std::span<const PlaneResult> planes, double height, std::span<const PlanStop> stops);

}  // namespace planewright
