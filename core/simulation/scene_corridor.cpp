// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <string>

#include "core/simulation/random.h"
#include "core/simulation/scene_builder.h"
#include "core/simulation/scenes.h"
#include "core/types/angle.h"

namespace planewright {

namespace {

constexpr double kCorridorWidth = 2.4;
constexpr double kCorridorLength = 30.0;
constexpr double kCorridorHeight = 2.6;
constexpr double kDoorHeight = 2.05;

/// The doors of one side: their places along y, and how far all of them are set back.
struct Doors {
    double first;    ///< where one of them begins, any of the row [m]
    double spacing;  ///< from door to door [m]
    double width;
    double depth;
};

/// Openings along the wall for all doors that fit into the corridor; `mirrored` where the wall runs towards −y.
std::vector<Opening> openingsOf(const Doors& doors, bool mirrored)
{
    double from = doors.first;
    while (from - doors.spacing > 0.3)
        from -= doors.spacing;
    std::vector<Opening> openings;
    for (; from + doors.width < kCorridorLength - 0.3; from += doors.spacing) {
        if (mirrored)
            openings.push_back({kCorridorLength - from - doors.width, kCorridorLength - from, 0.0, kDoorHeight});
        else
            openings.push_back({from, from + doors.width, 0.0, kDoorHeight});
    }
    return openings;
}

void addSide(SceneBuilder& room, const std::string& side, const WallPlan& plan, const Doors& doors)
{
    const std::vector<Opening> openings = openingsOf(doors, plan.to.y() < plan.from.y());
    room.wall(side + " wall", plan, openings);
    int number = 0;
    for (const Opening& opening : openings)
        room.recess(side + " door " + std::to_string(++number), plan, opening, doors.depth);
}

}  // namespace

/// A corridor with doors on both sides, as in Fig. 10 to 12; the sensor stands half-way along.
Scene makeCorridor(std::uint64_t seed)
{
    Random random(seed);
    SensorPose pose;
    pose.position = {0.5 * kCorridorWidth + random.uniform(-0.3, 0.3), random.uniform(14.5, 15.5),
                     random.uniform(0.9, 1.1)};
    pose.yaw = degrees(random.uniform(-10.0, 10.0));

    // Doors of both sides never stand exactly opposite, so that no two jambs nearly line up across the corridor.
    Doors right;
    right.first = pose.position.y() + random.uniform(0.5, 1.0);
    right.spacing = random.uniform(2.8, 3.4);
    right.width = 0.95;
    right.depth = random.uniform(0.05, 0.10);
    Doors left = right;
    left.first += random.uniform(0.25, 0.6);
    left.depth = random.uniform(0.05, 0.10);

    SceneBuilder room("corridor");
    // The floor reaches under the doors.
    room.level("floor", 0.0, {-0.1, 0.0}, {kCorridorWidth + 0.1, kCorridorLength});
    room.level("ceiling", kCorridorHeight, {0.0, 0.0}, {kCorridorWidth, kCorridorLength});
    addSide(room, "right", {{kCorridorWidth, 0.0}, {kCorridorWidth, kCorridorLength}, 0.0, kCorridorHeight}, right);
    addSide(room, "left", {{0.0, kCorridorLength}, {0.0, 0.0}, 0.0, kCorridorHeight}, left);
    room.wall("end wall", {{kCorridorWidth, kCorridorLength}, {0.0, kCorridorLength}, 0.0, kCorridorHeight});
    room.wall("back wall", {{0.0, 0.0}, {kCorridorWidth, 0.0}, 0.0, kCorridorHeight});
    return room.build(pose);
}

}  // namespace planewright
