// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/geometry/pose.h"
#include "core/mapping/building_map.h"
#include "core/types/plane.h"

namespace planewright {

/// A plane as the scan of a stop has it.
struct StopPlane {
    int scan = 0;  ///< of the file
    PlaneId plane = kNoPlane;
};

/// A stop of a map as people see it. Poses are in the frame of the building.
struct ShownStop {
    int number = -1;  ///< from 0; −1: it was taken out
    int scan = 0;     ///< of the file
    std::string name;
    int floor = 0;
    bool isPlaced = false;
    Pose pose;                 ///< corrected
    std::optional<Pose> raw;   ///< where odometry alone would have it
    std::optional<Pose> told;  ///< what odometry says, in its own frame
    double sigmaShift = 0.0;   ///< of the worst direction [m]
    double sigmaTurn = 0.0;    ///< [rad]
    std::string trust;         ///< what its place rests on
    std::string warning;       ///< what to do about it; empty where all is well
    int matched = 0;
    int fresh = 0;
    int open = 0;

    bool isOmitted() const { return number < 0; }
};

/// What a stop's plane is in the map.
struct ShownMatch {
    int stop = 0;  ///< its number
    StopPlane own;
    std::string className;
    double area = 0.0;  ///< [m²]
    MatchState state = MatchState::Open;
    PlaneId plane = kNoPlane;     ///< of the map
    std::vector<PlaneId> rivals;  ///< of the map: an open one may be any of these
    double chiSquare = 0.0;       ///< as it was matched, 3 expected
    bool isByHand = false;
};

/// What is known of a plane of the map beside its outline.
struct ShownMapPlane {
    int floor = 0;
    int firstStop = 0;              ///< that saw it
    double sigma = 0.0;             ///< of its place in its middle [m]
    std::vector<StopPlane> seenBy;  ///< in the order in which it was seen
};

/// A map of several stops beside its planes.
struct ShownBuilding {
    std::vector<ShownStop> stops;       ///< in their order, then those that were taken out
    std::vector<ShownMatch> matches;    ///< of the stops that are placed, in their order
    std::vector<ShownMapPlane> planes;  ///< as those of the map that is shown
    std::vector<int> floors;            ///< from the lowest up
    int allStops = 0;                   ///< as many as there would be after the last one
};

}  // namespace planewright
