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

/// Slats in one plane, and slats that are a plane each: fences and louvres.
void addSlats(SceneBuilder& yard, Random& random)
{
    const double y = random.uniform(2.8, 3.2);
    constexpr double kWidth = 0.025;
    const int fence = yard.wall("fence", {{-2.0, y}, {-2.0 + kWidth, y}, -0.5, 0.8});
    for (int i = 1; i < 20; ++i)
        yard.extend(fence, {-2.0 + 2.0 * kWidth * i, y, -0.5}, {kWidth, 0.0, 0.0}, {0.0, 0.0, 1.3});

    const double turn = degrees(random.uniform(20.0, 50.0));
    const Eigen::Vector3d slat(0.0, 0.06 * std::cos(turn), 0.06 * std::sin(turn));
    for (int i = 0; i < 10; ++i)
        yard.rectangle("louvre " + std::to_string(i + 1), {0.3, 2.5, -0.4 + 0.08 * i}, {0.8, 0.0, 0.0}, slat);
    for (int i = 0; i < 8; ++i)
        yard.wall("rib " + std::to_string(i + 1),
                  {{1.3 + 0.1 * i, 3.4 + 0.02 * i}, {1.4 + 0.1 * i, 3.4 + 0.02 * i}, -0.6, 0.9});
}

/// Surfaces that a scanner sees edge-on, through its own axis, or along almost all their length.
void addGrazing(SceneBuilder& yard, Random& random)
{
    const double slope = degrees(random.uniform(20.0, 60.0));
    const Eigen::Vector3d outwards(0.0, std::cos(slope), -std::sin(slope));
    yard.rectangle("through the pitch axis", Eigen::Vector3d(-0.6, 0.0, 0.0) + 0.5 * outwards, {1.2, 0.0, 0.0},
                   1.2 * outwards);
    yard.rectangle("through the laser's axis", {0.0, 1.5, 0.6}, {0.0, 1.0, 0.0}, {0.0, 0.0, 0.8});
    yard.wall("long wall beside", {{0.16, 4.5}, {0.4, 32.0}, -0.3, 0.3});
    yard.level("slab at eye level", -0.03, {-3.5, 1.0}, {-2.2, 6.0});
    yard.level("ground", -1.0, {-6.0, 0.0}, {6.0, 12.0});
}

/// Parallel surfaces that no range noise lets anyone tell apart, and glass.
void addNearlyTheSame(SceneBuilder& yard, Random& random)
{
    const double y = random.uniform(7.5, 8.5);
    const int glazed = yard.wall("back wall", {{6.0, y}, {-6.0, y}, -1.0, 2.0});
    yard.wall("board 1 cm before it", {{1.8, y - 0.01}, {0.6, y - 0.01}, -0.5, 1.5});
    const int glass = yard.wall("glass", {{-1.0, y - 0.5}, {-4.0, y - 0.5}, -1.0, 2.0});
    yard.makeGlass(glass, 0.7);
    yard.makeGlass(glazed, 0.1);
    yard.rectangle("wall off the vertical by 1°", {-6.0, 2.0, -1.0}, {0.0, 4.0, 0.0},
                   {3.0 * std::sin(degrees(1.0)), 0.0, 3.0 * std::cos(degrees(1.0))});
    yard.rectangle("wall beneath it", {-6.0, 6.0, -1.0}, {0.0, 2.0, 0.0}, {0.0, 0.0, 3.0});
}

/// What is as near as the laser sees, as far, and smaller than it resolves.
void addLimits(SceneBuilder& yard, Random& random)
{
    yard.rectangle("as near as it sees", {0.06, -0.05, 0.05}, {0.02, 0.1, 0.0}, {0.0, 0.0, 0.08});
    yard.wall("as far as it sees", {{29.8, 2.0}, {29.9, 8.0}, -1.0, 3.0});
    yard.wall("farther than it sees", {{30.5, 8.0}, {30.5, 9.0}, -1.0, 3.0});
    for (int i = 0; i < 12; ++i) {
        const double up = random.uniform(-0.8, 1.5);
        const double ahead = random.uniform(1.0, 5.0);
        const Eigen::Vector3d at(random.uniform(2.0, 5.0), ahead, up);
        const double yaw = random.uniform(0.0, degrees(180.0));
        yard.rectangle("chip " + std::to_string(i + 1), at, 0.03 * Eigen::Vector3d(std::cos(yaw), std::sin(yaw), 0.0),
                       {0.0, 0.0, 0.03});
    }
    for (int i = 0; i < 8; ++i) {
        const double radius = random.uniform(0.003, 0.008);
        yard.pole({random.uniform(-5.0, 5.0), random.uniform(1.5, 6.0), -1.0}, {0.0, 0.0, 3.0}, radius);
    }
}

}  // namespace

/// A yard of everything that is nasty for algorithms. Here alone true planes may lie closer than noise can tell.
Scene makeHostile(std::uint64_t seed)
{
    Random random(seed);
    SceneBuilder yard("hostile");
    addSlats(yard, random);
    addGrazing(yard, random);
    addNearlyTheSame(yard, random);
    addLimits(yard, random);
    return yard.build({});
}

}  // namespace planewright
