// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>

#include "core/simulation/random.h"
#include "core/simulation/scene_builder.h"
#include "core/simulation/scenes.h"
#include "core/types/angle.h"

namespace planewright {

namespace {

/// The right wall: a cylinder through both corners, bent outwards or into the room.
void addCurvedWall(SceneBuilder& room, double x, double length, double height, double radius, bool outwards)
{
    const double toChord = std::sqrt(radius * radius - 0.25 * length * length);
    const Eigen::Vector3d centre(outwards ? x - toChord : x + toChord, 0.5 * length, 0.0);
    // Sectors run counter-clockwise seen from above: from the near corner if the centre is inside, else from the far.
    const Eigen::Vector3d begin(x, outwards ? 0.0 : length, 0.0);
    room.cylinder(centre, {0.0, 0.0, height}, begin - centre, 2.0 * std::asin(0.5 * length / radius));
}

}  // namespace

/// A room whose right wall is a gentle curve, as at the right of Fig. 12.
Scene makeCurved(std::uint64_t seed)
{
    Random random(seed);
    const double width = random.uniform(5.5, 7.0);
    const double length = random.uniform(9.0, 11.0);
    const double height = random.uniform(2.6, 3.0);
    SensorPose pose;
    pose.position = {random.uniform(0.4, 0.6) * width, random.uniform(1.0, 2.0), random.uniform(0.9, 1.2)};
    pose.yaw = degrees(random.uniform(-10.0, 10.0));

    SceneBuilder room("curved");
    const bool outwards = random.uniform() < 0.5;
    addCurvedWall(room, width, length, height, random.uniform(12.0, 18.0), outwards);
    // Floor and ceiling reach under and above the bow.
    const double reach = width + (outwards ? 2.0 : 0.0);
    room.level("floor", 0.0, {-0.1, 0.0}, {reach, length});
    room.level("ceiling", height, {0.0, 0.0}, {reach, length});

    const WallPlan left{{0.0, length}, {0.0, 0.0}, 0.0, height};
    const double begin = random.uniform(0.35, 0.5) * length;
    const Opening door{begin, begin + 1.0, 0.0, 2.05};
    room.wall("left wall", left, {door});
    room.recess("door", left, door, random.uniform(0.06, 0.10));
    room.wall("end wall", {{width, length}, {0.0, length}, 0.0, height});
    room.wall("back wall", {{0.0, 0.0}, {width, 0.0}, 0.0, height});
    const double side = random.uniform(0.7, 1.0);
    room.box("box",
             {{0.4 * width, length - 2.0}, {side, side, random.uniform(0.6, 0.85)}, 0.0, random.uniform(0.2, 0.6)});
    return room.build(pose);
}

}  // namespace planewright
