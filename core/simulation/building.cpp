// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/simulation/building.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <string>
#include <utility>

#include <Eigen/Geometry>

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
constexpr double kFlight = 1.0;                   // width [m]
constexpr double kStairsWay = kBayEnd - kFlight;  // of the ring, to where both flights are in front
constexpr double kGoing = 0.28;
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
    mirrored.reserve(passages.size());
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

/// Of a flight as the plan shows it, from its lowest riser to where it arrives above.
Eigen::AlignedBox2d flightFrom(int floor)
{
    // One above the other there would be no way past them; each second one leads up beside the first.
    const double right = kBayEnd - (floor % 2) * kFlight;
    const double begin = kHalfRing + 0.3;
    return {Eigen::Vector2d(right - kFlight, begin), Eigen::Vector2d(right, begin + kSteps * kGoing)};
}

/// The flight that leads up from a floor, which lies at a height.
void addFlight(SceneBuilder& floor, const std::string& name, const Eigen::AlignedBox2d& flight, double height)
{
    constexpr double kRise = SimulatedBuilding::kStoreyHeight / kSteps;
    for (int i = 0; i < kSteps; ++i) {
        const double y = flight.min().y() + i * kGoing;
        const std::string step = name + " " + std::to_string(i + 1);
        const double bottom = height + i * kRise;
        floor.wall(step + " riser", {{flight.max().x(), y}, {flight.min().x(), y}, bottom, bottom + kRise});
        floor.level(step + " tread", bottom + kRise, {flight.min().x(), y}, {flight.max().x(), y + kGoing});
    }
}

/// A horizontal plane that is open where another rectangle is.
void addAround(SceneBuilder& floor, const std::string& name, double height, const Eigen::AlignedBox2d& plan,
               const Eigen::AlignedBox2d& open)
{
    const int plane = floor.level(name, height, plan.min(), {plan.max().x(), open.min().y()});
    const auto more = [&](const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
        floor.extend(plane, {from.x(), from.y(), height}, {to.x() - from.x(), 0.0, 0.0}, {0.0, to.y() - from.y(), 0.0});
    };
    more({plan.min().x(), open.min().y()}, {open.min().x(), open.max().y()});
    more({open.max().x(), open.min().y()}, {plan.max().x(), open.max().y()});
    more({plan.min().x(), open.max().y()}, plan.max());
}

/// The stairwell: its walls go up through the ceiling and down to the floor below, as flights do.
void addStairwell(SceneBuilder& floor, int number, bool isHighest)
{
    const double front = kHalfRing;
    const double back = kHalfRing + kBayDepth;
    const double top = SimulatedBuilding::kStoreyHeight;
    const double bottom = number > 0 ? -SimulatedBuilding::kStoreyHeight : 0.0;
    floor.wall("stairwell left wall", {{kBayBegin, back}, {kBayBegin, front}, bottom, top});
    floor.wall("stairwell right wall", {{kBayEnd, front}, {kBayEnd, back}, bottom, top});
    floor.wall("stairwell end wall", {{kBayEnd, back}, {kBayBegin, back}, bottom, top});
    if (!isHighest)
        addFlight(floor, "step", flightFrom(number), 0.0);
    if (number > 0) {
        addFlight(floor, "step down", flightFrom(number - 1), bottom);
        floor.level("floor below", bottom, {kBayBegin, front}, {kBayEnd, back});
    }
}

SceneBuilder makeFloor(int number, bool isHighest, std::uint64_t seed)
{
    Random random(seed, 1000 + static_cast<std::uint64_t>(number));
    SceneBuilder floor("floor " + std::to_string(number));
    const double h = kHalfRing;
    const Eigen::AlignedBox2d plan(Eigen::Vector2d(-kShell, -kShell),
                                   Eigen::Vector2d(kRingLength + kShell, kRingWidth + kShell));
    if (number > 0)
        addAround(floor, "floor", 0.0, plan, flightFrom(number - 1));
    else
        floor.level("floor", 0.0, plan.min(), plan.max());
    // Open above the stairwell.
    addAround(floor, "ceiling", kCeilingHeight, plan,
              {Eigen::Vector2d(kBayBegin, h), Eigen::Vector2d(kBayEnd, h + kBayDepth)});

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
    addStairwell(floor, number, isHighest);
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
    way = std::fmod(way, kAround);
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

/// `gaze` is to the left of the way [rad].
Pose stopOnRing(double way, double gaze, Random& random)
{
    const auto [place, heading] = placeOnRing(way);
    // The scanner looks along its y.
    const double yaw = heading + gaze - degrees(90.0) + random.uniform(-0.2, 0.2);
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
        floors_.push_back(makeFloor(floor, floor + 1 == floors, seed));
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
            BuildingStop stop{floor, {}, {}};
            if (floors() == 1)
                stop.pose = stopOnRing(kAround * (i + 0.5) / count, 0.0, random);
            else if (i == 0)
                stop.pose = stopOnRing(kStairsWay, degrees(90.0), random);
            else
                stop.pose = stopOnRing(kStairsWay + kAround * (i - 1) / (count - 1), 0.0, random);
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
