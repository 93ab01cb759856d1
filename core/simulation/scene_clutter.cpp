// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>
#include <string>
#include <vector>

#include "core/simulation/random.h"
#include "core/simulation/scene_builder.h"
#include "core/simulation/scenes.h"
#include "core/types/angle.h"

namespace planewright {

namespace {

constexpr double kClutterWidth = 7.0;
constexpr double kClutterLength = 6.5;
constexpr double kClutterHeight = 2.8;

/// Gives out places on the floor that keep clear of each other, of the walls and of the sensor.
class Places {
public:
    Places(Random& random, const Eigen::Vector2d& sensor) : random_(random) { taken_.push_back({sensor, 0.9}); }

    /// A place for something round of a radius; the last one tried where the room is full, which then overlaps.
    Eigen::Vector2d next(double radius)
    {
        const double margin = radius + 0.1;
        Eigen::Vector2d centre;
        for (int attempt = 0; attempt < 1000; ++attempt) {
            centre = {random_.uniform(margin, kClutterWidth - margin),
                      random_.uniform(margin, kClutterLength - margin)};
            if (isFree(centre, radius))
                break;
        }
        taken_.push_back({centre, radius});
        return centre;
    }

private:
    struct Disc {
        Eigen::Vector2d centre;
        double radius;
    };

    bool isFree(const Eigen::Vector2d& centre, double radius) const
    {
        for (const Disc& disc : taken_)
            if ((disc.centre - centre).norm() < disc.radius + radius + 0.15)
                return false;
        return true;
    }

    Random& random_;
    std::vector<Disc> taken_;
};

/// A board that leans: its lower edge on the floor, tipped back from the vertical.
void addLeaningBoard(SceneBuilder& room, const std::string& name, const Eigen::Vector2d& at, Random& random)
{
    const double yaw = random.uniform(0.0, degrees(180.0));
    const double tip = degrees(random.uniform(15.0, 40.0));
    const double width = random.uniform(0.5, 0.7);
    const double height = random.uniform(0.6, 0.9);
    const Eigen::Vector3d across = width * Eigen::Vector3d(std::cos(yaw), std::sin(yaw), 0.0);
    const Eigen::Vector3d back(-std::sin(yaw), std::cos(yaw), 0.0);
    const Eigen::Vector3d up = height * (std::cos(tip) * Eigen::Vector3d::UnitZ() + std::sin(tip) * back);
    room.rectangle(name, Eigen::Vector3d(at.x(), at.y(), 0.0) - 0.5 * across, across, up);
}

}  // namespace

/// A room full of boxes turned at odd angles, leaning boards, drums, poles and a pipe.
Scene makeClutter(std::uint64_t seed)
{
    Random random(seed);
    SensorPose pose;
    pose.position = {random.uniform(3.0, 4.0), random.uniform(0.6, 1.0), random.uniform(0.9, 1.2)};
    pose.yaw = degrees(random.uniform(-10.0, 10.0));

    SceneBuilder room("clutter");
    room.level("floor", 0.0, {0.0, 0.0}, {kClutterWidth, kClutterLength});
    room.level("ceiling", kClutterHeight, {0.0, 0.0}, {kClutterWidth, kClutterLength});
    room.wall("right wall", {{kClutterWidth, 0.0}, {kClutterWidth, kClutterLength}, 0.0, kClutterHeight});
    room.wall("end wall", {{kClutterWidth, kClutterLength}, {0.0, kClutterLength}, 0.0, kClutterHeight});
    room.wall("left wall", {{0.0, kClutterLength}, {0.0, 0.0}, 0.0, kClutterHeight});
    room.wall("back wall", {{0.0, 0.0}, {kClutterWidth, 0.0}, 0.0, kClutterHeight});

    Places places(random, pose.position.head<2>());
    const int boxes = random.integer(11, 14);
    for (int i = 0; i < boxes; ++i) {
        const double height = random.uniform(0.2, 1.1);
        const double depth = random.uniform(0.25, 0.6);
        const Eigen::Vector3d size(random.uniform(0.25, 0.7), depth, height);
        const Eigen::Vector2d at = places.next(0.5 * std::hypot(size.x(), size.y()));
        const std::string name = "box " + std::to_string(i + 1);
        const double yaw = random.uniform(0.0, degrees(90.0));
        room.box(name, {at, size, 0.0, yaw});
        if (i % 4 == 0)
            room.box(name + " upper", {at, 0.6 * size, size.z(), yaw + degrees(random.uniform(20.0, 70.0))});
    }
    for (int i = 0; i < 3; ++i)
        addLeaningBoard(room, "board " + std::to_string(i + 1), places.next(0.5), random);
    for (int i = 0; i < 4; ++i) {
        const double radius = random.uniform(0.12, 0.3);
        const Eigen::Vector2d at = places.next(radius);
        room.pole({at.x(), at.y(), 0.0}, {0.0, 0.0, random.uniform(0.4, 1.0)}, radius);
    }
    for (int i = 0; i < 4; ++i) {
        const double radius = random.uniform(0.015, 0.04);
        const Eigen::Vector2d at = places.next(radius);
        room.pole({at.x(), at.y(), 0.0}, {0.0, 0.0, kClutterHeight}, radius);
    }
    room.pole({0.0, random.uniform(2.0, 5.0), kClutterHeight - 0.25}, {kClutterWidth, 0.0, 0.0}, 0.08);
    return room.build(pose);
}

}  // namespace planewright
