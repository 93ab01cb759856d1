// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tests/benchmarks/room_details.h"

#include <algorithm>
#include <cstdio>

namespace planewright {

namespace {

/// e'Fe beyond which a plane is worth a line; 3 is expected at the bound.
constexpr double kFar = 25.0;

void printRoom(const Room& room)
{
    std::printf("  %s %llu ", room.name.c_str(), static_cast<unsigned long long>(room.seed));
}

void printPlane(const Eigen::Vector3d& normal, double distance)
{
    std::printf("n=(%.2f %.2f %.2f) d=%.3f ", normal.x(), normal.y(), normal.z(), distance);
}

std::ptrdiff_t returnsOf(const PlaneGroup& group, const SimulatedScan& scan)
{
    std::ptrdiff_t returns = 0;
    for (const std::vector<int>& line : scan.labels)
        returns += std::count_if(line.begin(), line.end(), [&](int label) {
            return std::find(group.begin(), group.end(), label) != group.end();
        });
    return returns;
}

void printMissed(const Room& room, const PlaneGroup& group)
{
    const TruePlane& plane = room.scene.planes[static_cast<std::size_t>(group.front())];
    printRoom(room);
    std::printf("missed %s ", plane.name.c_str());
    printPlane(plane.normal, plane.distance);
    std::printf("returns %td\n", returnsOf(group, room.scan));
}

void printFalse(const Room& room, const Plane& plane)
{
    printRoom(room);
    std::printf("false P%d ", plane.id);
    printPlane(plane.normal, plane.distance);
    std::printf("points %d segments %zu error %.2f\n", plane.points, plane.segments.size(), plane.fittingError);
}

void printFar(const Room& room, const PlaneDeviation& deviation, const Plane& plane)
{
    printRoom(room);
    std::printf("P%d %s e'Fe %.1f e'C-1e %.1f points %d segs %zu\n", plane.id,
                room.scene.planes[static_cast<std::size_t>(deviation.truth)].name.c_str(), deviation.bound,
                deviation.own, plane.points, plane.segments.size());
}

}  // namespace

void printDetails(const Room& room, const RoomAccuracy& accuracy)
{
    for (const PlaneGroup& group : accuracy.at50.missed)
        printMissed(room, group);
    for (const int id : accuracy.at50.noise)
        printFalse(room, planeOf(id, *accuracy.found));
    for (const PlaneDeviation& deviation : accuracy.deviations) {
        if (deviation.bound > kFar)
            printFar(room, deviation, planeOf(deviation.id, *accuracy.found));
    }
}

}  // namespace planewright
