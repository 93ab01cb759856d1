// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <string>

#include "core/simulation/random.h"
#include "core/simulation/scene_builder.h"
#include "core/simulation/scenes.h"
#include "core/types/angle.h"

namespace planewright {

namespace {

constexpr int kSteps = 12;
constexpr double kRise = 0.17;
constexpr double kGoing = 0.29;

}  // namespace

/// A flight of stairs between two walls, up to a landing; the sensor stands on the floor before it.
Scene makeStairs(std::uint64_t seed)
{
    Random random(seed);
    const double width = random.uniform(1.8, 2.4);
    const double top = kSteps * kRise;
    const double height = top + random.uniform(2.4, 2.7);
    SensorPose pose;
    pose.position = {random.uniform(0.4, 0.6) * width, random.uniform(1.0, 1.5), random.uniform(1.0, 1.4)};
    pose.yaw = degrees(random.uniform(-8.0, 8.0));
    const double begin = pose.position.y() + random.uniform(1.0, 1.6);
    const double landing = begin + (kSteps - 1) * kGoing;
    const double end = landing + random.uniform(1.5, 2.2);

    SceneBuilder stairs("stairs");
    stairs.level("floor", 0.0, {0.0, 0.0}, {width, begin});
    stairs.level("ceiling", height, {0.0, 0.0}, {width, end});
    stairs.wall("right wall", {{width, 0.0}, {width, end}, 0.0, height});
    stairs.wall("end wall", {{width, end}, {0.0, end}, 0.0, height});
    stairs.wall("left wall", {{0.0, end}, {0.0, 0.0}, 0.0, height});
    stairs.wall("back wall", {{0.0, 0.0}, {width, 0.0}, 0.0, height});
    for (int i = 0; i < kSteps; ++i) {
        const double y = begin + i * kGoing;
        const std::string number = std::to_string(i + 1);
        stairs.wall("riser " + number, {{width, y}, {0.0, y}, i * kRise, (i + 1) * kRise});
        if (i + 1 < kSteps)
            stairs.level("tread " + number, (i + 1) * kRise, {0.0, y}, {width, y + kGoing});
    }
    stairs.level("landing", top, {0.0, landing}, {width, end});
    return stairs.build(pose);
}

}  // namespace planewright
