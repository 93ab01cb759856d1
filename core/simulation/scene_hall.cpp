// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <array>
#include <cmath>
#include <string>

#include "core/simulation/random.h"
#include "core/simulation/scene_builder.h"
#include "core/simulation/scenes.h"
#include "core/types/angle.h"

namespace planewright {

namespace {

constexpr double kHallWidth = 20.0;
constexpr double kHallLength = 25.0;

/// Half a pillar that stands out of a side wall, whose room side is +x or −x of it.
void addPilaster(SceneBuilder& hall, const std::string& name, double wallX, double y, const Eigen::Vector2d& size,
                 double height)
{
    const bool leftWall = wallX == 0.0;
    const double x = leftWall ? 0.5 * size.x() : wallX - 0.5 * size.x();
    const unsigned faces = (leftWall ? kRight : kLeft) | kFront | kBack;
    hall.box(name, {{x, y}, {size.x(), size.y(), height}}, faces);
}

}  // namespace

/// A hall of 20 m × 25 m with square pillars, as in Fig. 13; the sensor stands near the middle of a short wall.
Scene makeHall(std::uint64_t seed)
{
    Random random(seed);
    const double height = random.uniform(3.6, 4.4);
    SensorPose pose;
    pose.position = {random.uniform(9.0, 11.0), random.uniform(1.0, 2.0), random.uniform(0.9, 1.2)};
    pose.yaw = degrees(random.uniform(-10.0, 10.0));

    SceneBuilder hall("hall");
    hall.level("floor", 0.0, {0.0, 0.0}, {kHallWidth, kHallLength});
    hall.level("ceiling", height, {0.0, 0.0}, {kHallWidth, kHallLength});
    hall.wall("right wall", {{kHallWidth, 0.0}, {kHallWidth, kHallLength}, 0.0, height});
    hall.wall("end wall", {{kHallWidth, kHallLength}, {0.0, kHallLength}, 0.0, height});
    hall.wall("left wall", {{0.0, kHallLength}, {0.0, 0.0}, 0.0, height});
    hall.wall("back wall", {{0.0, 0.0}, {kHallWidth, 0.0}, 0.0, height});

    // Rows: the faces of pillars in a row are coplanar, as they are in buildings.
    const double side = random.uniform(0.7, 0.9);
    const std::array columns{random.uniform(5.0, 6.5), random.uniform(13.5, 15.0)};
    const std::array rows{random.uniform(6.0, 7.5), random.uniform(13.0, 15.0)};
    int number = 0;
    for (const double y : rows)
        for (const double x : columns)
            hall.box("pillar " + std::to_string(++number), {{x, y}, {side, side, height}},
                     kLeft | kRight | kFront | kBack);

    const Eigen::Vector2d pilaster(random.uniform(0.35, 0.5), side);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        addPilaster(hall, "left pilaster " + std::to_string(i + 1), 0.0, rows[i], pilaster, height);
        addPilaster(hall, "right pilaster " + std::to_string(i + 1), kHallWidth, rows[i], pilaster, height);
    }

    // Free-standing partitions, thin enough to be one plane; the first faces the sensor, the others stand askew.
    const int partitions = random.integer(1, 3);
    for (int i = 0; i < partitions; ++i) {
        const double ahead = random.uniform(9.5, 11.0);
        const Eigen::Vector2d middle(6.5 + 3.5 * i + random.uniform(-0.4, 0.4), ahead);
        const double turn = i == 0 ? 0.0 : degrees(random.uniform(15.0, 35.0));
        const Eigen::Vector2d half = Eigen::Vector2d(std::cos(turn), std::sin(turn)) * random.uniform(0.9, 1.2);
        hall.wall("partition " + std::to_string(i + 1), {middle - half, middle + half, 0.0, random.uniform(1.5, 1.9)});
    }
    return hall.build(pose);
}

}  // namespace planewright
