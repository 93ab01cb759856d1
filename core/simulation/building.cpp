// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/simulation/building.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <string>
#include <utility>

#include "core/simulation/random.h"
#include "core/types/angle.h"

namespace planewright {

namespace {

constexpr double kCeilingHeight = 2.8;
constexpr double kLintelHeight = 2.1;
constexpr double kDoorway = 0.9;
constexpr double kHalfRing = 1.2;     // from the ring's middle to its walls [m]
constexpr double kRingLength = 20.0;  // along x [m]
constexpr double kRingWidth = 10.0;   // along y [m]
constexpr double kWall = 0.15;
constexpr double kAround = 2.0 * (kRingLength + kRingWidth);
constexpr double kShell = 8.0;  // from the ring's middle to the end of floor and ceiling [m]

// The stairwell is a bay in the core's wall along x.
constexpr double kBayBegin = 8.4;
constexpr double kBayEnd = 11.4;
constexpr double kBayDepth = 5.6;
constexpr int kSteps = 16;

struct Stretch {
    Eigen::Vector2d from;
    Eigen::Vector2d to;

    double length() const { return (to - from).norm(); }
    Eigen::Vector2d along() const { return (to - from) / length(); }
    /// To the side where the corridor is not.
    Eigen::Vector2d outwards() const { return {along().y(), -along().x()}; }
};

/// A wall with a face on either side, the corridor on the left of its way, and the passages through it.
void addThickWall(SceneBuilder& floor, const std::string& name, const Stretch& way,
                  const std::vector<Opening>& passages)
{
    const Eigen::Vector2d back = kWall * way.outwards();
    floor.wall(name, {way.from, way.to, 0.0, kCeilingHeight}, passages);
    std::vector<Opening> mirrored;
    for (const Opening& passage : passages)
        mirrored.push_back({way.length() - passage.to, way.length() - passage.from, passage.bottom, passage.top});
    floor.wall(name + " back", {way.to + back, way.from + back, 0.0, kCeilingHeight}, mirrored);
    int number = 0;
    for (const Opening& passage : passages) {
        const std::string door = name + " door " + std::to_string(++number);
        const Eigen::Vector2d near = way.from + passage.from * way.along();
        const Eigen::Vector2d far = way.from + passage.to * way.along();
        floor.wall(door + " jamb 1", {near, near + back, 0.0, passage.top});
        floor.wall(door + " jamb 2", {far + back, far, 0.0, passage.top});
        floor.rectangle(door + " lintel", {near.x(), near.y(), passage.top},
                        {far.x() - near.x(), far.y() - near.y(), 0.0}, {back.x(), back.y(), 0.0});
    }
}

/// The room behind a stretch of a thick wall, and what stands in it.
void addRoom(SceneBuilder& floor, const std::string& name, const Stretch& front, double depth, Random& random)
{
    const Eigen::Vector2d in = front.outwards();
    const Eigen::Vector2d nearA = front.from + 0.1 * front.along() + kWall * in;
    const Eigen::Vector2d nearB = front.to - 0.1 * front.along() + kWall * in;
    // One room in two has a slanted back.
    const double slant = random.uniform() < 0.5 ? random.uniform(0.2, 0.6) : 0.0;
    const Eigen::Vector2d farA = nearA + depth * in;
    const Eigen::Vector2d farB = nearB + (depth + slant) * in;
    floor.wall(name + " side 1", {nearA, farA, 0.0, kCeilingHeight});
    floor.wall(name + " end", {farA, farB, 0.0, kCeilingHeight});
    floor.wall(name + " side 2", {farB, nearB, 0.0, kCeilingHeight});
    for (int i = 1; i <= 2; ++i) {
        const double across = random.uniform(0.2, 0.8);
        const double deep = random.uniform(0.5, 0.85);
        BoxPlan box;
        box.centre = nearA + across * (nearB - nearA) + deep * depth * in;
        const double width = random.uniform(0.5, 1.2);
        const double length = random.uniform(0.4, 0.8);
        box.size = {width, length, random.uniform(0.7, 1.9)};
        box.yaw = random.uniform(-0.3, 0.3);
        floor.box(name + " cupboard " + std::to_string(i), box);
    }
}

/// One side of the ring with its rooms; whoever walks along it has the corridor on the left.
void addOuterSide(SceneBuilder& floor, const std::string& name, const Stretch& side, Random& random)
{
    std::vector<Opening> doors;
    int number = 0;
    double from = 0.2;
    while (from + 3.0 < side.length()) {
        const double width = std::min(random.uniform(3.0, 5.5), side.length() - from - 0.2);
        const double door = from + random.uniform(0.8, width - 0.8);
        doors.push_back({door - 0.5 * kDoorway, door + 0.5 * kDoorway, 0.0, kLintelHeight});
        const Stretch front{side.from + from * side.along(), side.from + (from + width) * side.along()};
        const double depth = random.uniform(3.0, 5.0);
        addRoom(floor, name + " room " + std::to_string(++number), front, depth, random);
        from += width;
    }
    addThickWall(floor, name + " wall", side, doors);
}

/// A wall of the core, with closed doors set back, away from what is open in it.
void addCoreSide(SceneBuilder& floor, const std::string& name, const Stretch& side, const std::vector<Opening>& bays,
                 double depth, Random& random)
{
    const WallPlan plan{side.from, side.to, 0.0, kCeilingHeight};
    std::vector<Opening> openings = bays;
    std::vector<Opening> doors;
    for (double middle = random.uniform(1.0, 2.5); middle < side.length() - 1.0; middle += random.uniform(2.0, 5.0)) {
        const Opening door{middle - 0.5 * kDoorway, middle + 0.5 * kDoorway, 0.0, kLintelHeight};
        const bool isFree = std::ranges::none_of(
            bays, [&](const Opening& bay) { return door.to + 0.3 > bay.from && door.from - 0.3 < bay.to; });
        if (isFree)
            doors.push_back(door);
    }
    openings.insert(openings.end(), doors.begin(), doors.end());
    floor.wall(name, plan, openings);
    int number = 0;
    for (const Opening& door : doors)
        floor.recess(name + " door " + std::to_string(++number), plan, door, depth);
}

/// The stairwell: its walls go up through the ceiling, and a flight leads to the next floor on the right.
void addStairwell(SceneBuilder& floor, bool hasFlight)
{
    const double front = kHalfRing;
    const double back = kHalfRing + kBayDepth;
    const double top = SimulatedBuilding::kStoreyHeight;
    floor.wall("stairwell left wall", {{kBayBegin, back}, {kBayBegin, front}, 0.0, top});
    floor.wall("stairwell right wall", {{kBayEnd, front}, {kBayEnd, back}, 0.0, top});
    floor.wall("stairwell end wall", {{kBayEnd, back}, {kBayBegin, back}, 0.0, top});
    if (!hasFlight)
        return;
    const double left = 0.5 * (kBayBegin + kBayEnd);
    const double rise = top / kSteps;
    const double run = 0.28;
    for (int i = 0; i < kSteps; ++i) {
        const double y = front + 0.8 + i * run;
        const std::string step = "step " + std::to_string(i + 1);
        floor.wall(step + " riser", {{kBayEnd, y}, {left, y}, i * rise, (i + 1) * rise});
        floor.level(step + " tread", (i + 1) * rise, {left, y}, {kBayEnd, y + run});
    }
}

/// Open above the stairwell.
void addCeiling(SceneBuilder& floor, const Eigen::Vector2d& low, const Eigen::Vector2d& high)
{
    const double back = kHalfRing + kBayDepth;
    const int ceiling = floor.level("ceiling", kCeilingHeight, low, {high.x(), kHalfRing});
    const auto more = [&](const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
        floor.extend(ceiling, {from.x(), from.y(), kCeilingHeight}, {to.x() - from.x(), 0.0, 0.0},
                     {0.0, to.y() - from.y(), 0.0});
    };
    more({low.x(), kHalfRing}, {kBayBegin, back});
    more({kBayEnd, kHalfRing}, {high.x(), back});
    more({low.x(), back}, high);
}

SceneBuilder makeFloor(int number, bool hasFlight, std::uint64_t seed)
{
    Random random(seed, 1000 + static_cast<std::uint64_t>(number));
    SceneBuilder floor("floor " + std::to_string(number));
    const double h = kHalfRing;
    const Eigen::Vector2d low(-kShell, -kShell);
    const Eigen::Vector2d high(kRingLength + kShell, kRingWidth + kShell);
    floor.level("floor", 0.0, low, high);
    addCeiling(floor, low, high);

    // The core as it is seen from the corridor: clockwise.
    const Eigen::Vector2d inner[4] = {
        {h, h}, {h, kRingWidth - h}, {kRingLength - h, kRingWidth - h}, {kRingLength - h, h}};
    // The outer walls: counter-clockwise.
    const Eigen::Vector2d outer[4] = {
        {-h, -h}, {kRingLength + h, -h}, {kRingLength + h, kRingWidth + h}, {-h, kRingWidth + h}};
    const char* const innerNames[4] = {"core left wall", "core back wall", "core right wall", "core front wall"};
    const char* const outerNames[4] = {"front", "right", "back", "left"};
    for (int i = 0; i < 4; ++i) {
        const Stretch side{inner[i], inner[(i + 1) % 4]};
        std::vector<Opening> bays;
        if (i == 3)
            bays.push_back({kRingLength - h - kBayEnd, kRingLength - h - kBayBegin, 0.0, kCeilingHeight});
        const double depth = random.uniform(0.05, 0.1);
        addCoreSide(floor, innerNames[i], side, bays, depth, random);
    }
    addStairwell(floor, hasFlight);
    int pillars = 0;
    for (const bool isFront : {true, false}) {
        const double y = isFront ? h - 0.2 : kRingWidth - h + 0.2;
        for (double x = random.uniform(2.0, 4.0); x < kRingLength - 2.0; x += random.uniform(3.0, 6.0)) {
            const double width = random.uniform(0.3, 0.6);
            if (x + width < kBayBegin || x - width > kBayEnd)
                floor.box("pillar " + std::to_string(++pillars), {{x, y}, {width, 0.4, kCeilingHeight}},
                          kLeft | kRight | (isFront ? kFront : kBack));
        }
    }
    for (int i = 0; i < 4; ++i)
        addOuterSide(floor, outerNames[i], {outer[i], outer[(i + 1) % 4]}, random);
    return floor;
}

/// Where the ring is after so much of the way round, and how it leads on there.
struct RingPlace {
    Eigen::Vector2d place;
    double heading;  ///< of the way; 0 along x [rad]
};

RingPlace placeOnRing(double way)
{
    if (way < kRingLength)
        return {{way, 0.0}, 0.0};
    way -= kRingLength;
    if (way < kRingWidth)
        return {{kRingLength, way}, degrees(90.0)};
    way -= kRingWidth;
    if (way < kRingLength)
        return {{kRingLength - way, kRingWidth}, degrees(180.0)};
    return {{0.0, kRingWidth - (way - kRingLength)}, degrees(270.0)};
}

Pose stopOnRing(double way, Random& random)
{
    const auto [place, heading] = placeOnRing(way);
    // The scanner looks along its y.
    const double yaw = heading - degrees(90.0) + random.uniform(-0.2, 0.2);
    const double roll = random.uniform(-0.005, 0.005);
    const double pitch = random.uniform(-0.005, 0.005);
    const double x = place.x() + random.uniform(-0.3, 0.3);
    const double y = place.y() + random.uniform(-0.3, 0.3);
    const double z = random.uniform(1.095, 1.105);
    return {rotationAbout({0.0, 0.0, yaw}) * rotationAbout({roll, pitch, 0.0}), {x, y, z}};
}

/// The motion as wheels tell it: in the plane of the floor, with their errors.
Pose toldMotion(const Pose& motion, Random& random)
{
    const double way = motion.translation.norm();
    const OdometryNoise noise;
    const auto [shiftX, shiftY] = random.normalPair();
    const double turn = noise.turnPerRootMetre * std::sqrt(way) * random.normalPair().first;
    const Eigen::Vector3d shift = (noise.least + noise.way * way) * Eigen::Vector3d(shiftX, shiftY, 0.0);
    const double yaw = rotationVector(motion.rotation).z() + turn;
    const Eigen::Vector3d told = motion.translation + shift;
    return {rotationAbout({0.0, 0.0, yaw}), {told.x(), told.y(), 0.0}};
}

}  // namespace

SimulatedBuilding::SimulatedBuilding(int floors, std::uint64_t seed) : seed_(seed)
{
    for (int floor = 0; floor < floors; ++floor)
        floors_.push_back(makeFloor(floor, floor + 1 < floors, seed));
}

Scene SimulatedBuilding::sceneAt(int floor, const Pose& pose) const
{
    return floors_[static_cast<std::size_t>(floor)].buildAt(pose);
}

std::vector<BuildingStop> SimulatedBuilding::route(int stops) const
{
    assert(stops >= floors());
    Random random(seed_, 2000);
    std::vector<BuildingStop> route;
    for (int floor = 0; floor < floors(); ++floor) {
        const int first = stops * floor / floors();
        const int count = stops * (floor + 1) / floors() - first;
        for (int i = 0; i < count; ++i) {
            BuildingStop stop{floor, stopOnRing(kAround * (i + 0.5) / count, random), {}};
            if (i > 0) {
                const BuildingStop& before = route.back();
                stop.odometry = before.odometry * toldMotion(before.pose.inverse() * stop.pose, random);
            }
            route.push_back(stop);
        }
    }
    return route;
}

}  // namespace planewright
