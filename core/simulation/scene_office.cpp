// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>
#include <string>

#include "core/simulation/random.h"
#include "core/simulation/scene_builder.h"
#include "core/simulation/scenes.h"
#include "core/types/angle.h"

namespace planewright {

namespace {

/// An office is about this much; x to the right, y from the wall behind the sensor to the one with the window [m].
struct OfficeSize {
    double width;
    double length;
    double height;
};

void addShell(SceneBuilder& room, const OfficeSize& size, Random& random)
{
    // The floor reaches under the door.
    room.level("floor", 0.0, {-0.1, 0.0}, {size.width, size.length});
    room.level("ceiling", size.height, {0.0, 0.0}, {size.width, size.length});
    room.wall("right wall", {{size.width, 0.0}, {size.width, size.length}, 0.0, size.height});

    const WallPlan end{{size.width, size.length}, {0.0, size.length}, 0.0, size.height};
    const Opening window{size.width - 3.1, size.width - 1.2, 0.95, random.uniform(2.1, 2.3)};
    room.wall("window wall", end, {window});
    room.recess("window", end, window, random.uniform(0.15, 0.25));

    const WallPlan left{{0.0, size.length}, {0.0, 0.0}, 0.0, size.height};
    const double doorBegin = size.length - random.uniform(1.8, 2.0);
    const Opening door{doorBegin, doorBegin + 0.95, 0.0, 2.05};
    room.wall("left wall", left, {door});
    room.recess("door", left, door, random.uniform(0.06, 0.10));
    room.wall("back wall", {{0.0, 0.0}, {size.width, 0.0}, 0.0, size.height});

    const double boardWidth = random.uniform(1.5, 1.9);
    room.box("whiteboard", {{0.03, size.length - 0.3 - 0.5 * boardWidth}, {0.06, boardWidth, 1.1}, 0.85},
             kRight | kFront | kBack | kTop | kBottom);
}

/// The desk below the window, with a pedestal, a screen and a pile of books.
void addWindowDesk(SceneBuilder& room, double wallY, double top, Random& random)
{
    const double front = wallY - random.uniform(0.8, 0.9);
    room.level("desk 1 top", top, {0.9, front}, {2.7, wallY - 0.05});
    room.wall("desk 1 left side", {{0.93, front}, {0.93, wallY - 0.05}, 0.0, top});
    room.wall("desk 1 right side", {{2.67, front}, {2.67, wallY - 0.05}, 0.0, top});
    room.wall("desk 1 panel", {{0.93, wallY - 0.55}, {2.67, wallY - 0.55}, 0.2, top});
    room.box("pedestal", {{2.35, front + 0.17}, {0.42, 0.26, 0.55}}, kLeft | kRight | kFront | kTop);
    room.box("screen", {{random.uniform(1.5, 1.8), wallY - 0.3}, {0.58, 0.08, 0.36}, top + 0.20}, kStanding | kBottom);
    room.box("books", {{1.15, front + 0.25}, {0.30, 0.22, random.uniform(0.10, 0.14)}, top, random.uniform(0.2, 0.5)});
}

/// The desk at the right wall.
void addSideDesk(SceneBuilder& room, double wallX, double top, Random& random)
{
    const double begin = random.uniform(1.7, 1.9);
    const double end = begin + 0.8;
    room.level("desk 2 top", top, {wallX - 1.6, begin}, {wallX, end});
    room.wall("desk 2 near side", {{wallX, begin + 0.03}, {wallX - 1.6, begin + 0.03}, 0.0, top});
    room.wall("desk 2 far side", {{wallX, end - 0.03}, {wallX - 1.6, end - 0.03}, 0.0, top});
}

void addBookcase(SceneBuilder& room, double left, double wallY, Random& random)
{
    const double right = left + random.uniform(0.9, 1.1);
    const double front = wallY - 0.3;
    const double top = 1.9;
    room.wall("bookcase left side", {{left, front}, {left, wallY}, 0.0, top});
    room.wall("bookcase right side", {{right, front}, {right, wallY}, 0.0, top});
    constexpr int kBoards = 6;
    for (int i = 0; i < kBoards; ++i)
        room.level("bookcase board " + std::to_string(i + 1), 0.1 + (top - 0.1) * i / (kBoards - 1), {left, front},
                   {right, wallY});
}

void addChair(SceneBuilder& room, const Eigen::Vector2d& at, Random& random)
{
    constexpr double kHalf = 0.22;
    const double yaw = random.uniform(-0.6, 0.6);
    const Eigen::Vector3d across = 2.0 * kHalf * Eigen::Vector3d(std::cos(yaw), std::sin(yaw), 0.0);
    const Eigen::Vector3d along(-across.y(), across.x(), 0.0);
    const Eigen::Vector3d corner = Eigen::Vector3d(at.x(), at.y(), 0.46) - 0.5 * across - 0.5 * along;
    room.rectangle("chair seat", corner, across, along);
    room.rectangle("chair back", corner + Eigen::Vector3d(0.0, 0.0, 0.15), across, {0.0, 0.0, 0.35});
    room.pole({at.x(), at.y(), 0.0}, {0.0, 0.0, 0.45}, 0.03);
}

}  // namespace

/// An office with its furniture; the sensor stands near the wall opposite the window.
Scene makeOffice(std::uint64_t seed)
{
    Random random(seed);
    const OfficeSize size{random.uniform(5.8, 6.4), random.uniform(4.8, 5.4), random.uniform(2.5, 2.9)};
    SensorPose pose;
    pose.position = {random.uniform(2.6, 3.4), random.uniform(0.5, 0.8), random.uniform(1.15, 1.3)};
    pose.yaw = degrees(random.uniform(-10.0, 10.0));

    SceneBuilder room("office");
    addShell(room, size, random);
    const double deskTop = random.uniform(0.70, 0.76);
    addWindowDesk(room, size.length, deskTop, random);
    addSideDesk(room, size.width, deskTop, random);
    addBookcase(room, random.uniform(3.5, 3.8), size.length, random);
    const double cupboard = random.uniform(1.7, 2.0);
    room.box("cupboard", {{size.width - 0.225, size.length - 0.5}, {0.45, 1.0, cupboard}}, kLeft | kFront | kTop);
    addChair(room, {random.uniform(1.6, 2.0), size.length - 1.5}, random);
    room.pole({random.uniform(3.0, 3.3), size.length - 1.4, 0.0}, {0.0, 0.0, 0.35}, 0.15);

    const int boxes = random.integer(2, 3);
    for (int i = 0; i < boxes; ++i) {
        const double ahead = random.uniform(2.2, 2.6);
        const Eigen::Vector2d at(0.9 + 1.4 * i + random.uniform(-0.2, 0.2), ahead);
        const double height = random.uniform(0.25, 0.5);
        const double depth = random.uniform(0.3, 0.5);
        const Eigen::Vector3d boxSize(random.uniform(0.35, 0.6), depth, height);
        room.box("box " + std::to_string(i + 1), {at, boxSize, 0.0, random.uniform(-0.7, 0.7)});
    }
    return room.build(pose);
}

}  // namespace planewright
