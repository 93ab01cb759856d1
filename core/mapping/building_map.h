// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "core/geometry/pose.h"
#include "core/mapping/register_planes.h"
#include "core/mapping/stop.h"
#include "core/mapping/uncertain_plane.h"

namespace planewright {

/// What a stop's plane is in the map.
enum class MatchState {
    New,      ///< a plane that no stop before had seen
    Matched,  ///< a plane that the map had
    Open,     ///< it may be one of several planes, or its stop is not placed: no part of the map
};

/// A stop's plane and the plane of the map that it is.
struct MapMatch {
    MatchState state = MatchState::Open;
    std::optional<std::size_t> plane;  ///< in BuildingMap::planes; none while open
    std::vector<std::size_t> rivals;   ///< planes of the map that it may be; a single one: or else a new plane
    double chiSquare = 0.0;            ///< of the match when it was made, 3 expected
    bool isByHand = false;             ///< somebody said so: it is not decided again
};

/// What a stop's pose rests on.
enum class StopTrust {
    First,            ///< it is the frame of the map
    Planes,           ///< its planes, which allow no other pose in reach
    OdometryDecides,  ///< its planes would allow other poses, see `alternatives`: only odometry tells which
    AgainstOdometry,  ///< its planes, which allow one pose alone; odometry says another and is left out
    OdometryAlone,    ///< odometry: too few of its planes are in the map to check it
    Unplaced,         ///< nothing: its planes allow several poses or none, and it is no part of the map
};

/// What odometry tells of a stop against one that was placed before it.
struct StopMotion {
    std::size_t from = 0;
    Motion motion;
};

/// A stop in the map.
struct MapStop {
    std::shared_ptr<const Stop> stop;
    Pose pose;                               ///< of an unplaced stop, where it is expected
    Matrix6d covariance = Matrix6d::Zero();  ///< against the first stop: exact after an adjustment, else an upper bound
    StopTrust trust = StopTrust::Unplaced;
    std::optional<StopMotion> odometry;  ///< as far as it is a factor of the map
    std::vector<Pose> alternatives;      ///< other poses that its planes would allow
    std::vector<Pose> loopRivals;        ///< poses that what older stops saw would allow: the loop was left open
    PoseStrength strength;           ///< how well the planes fixed it as it joined; what they do not fix is odometry's
    double odometryChiSquare = 0.0;  ///< of odometry against the planes as it joined, 6 at most expected
    std::vector<MapMatch> matches;   ///< of each of its planes

    bool isPlaced() const { return trust != StopTrust::Unplaced; }
};

/// One observation of a plane: the plane's place in a stop's list.
struct Sighting {
    std::size_t stop = 0;
    std::size_t plane = 0;
};

/// A plane of the map.
struct MapPlane {
    UncertainPlane parameters;             ///< in the map's frame
    std::vector<Sighting> sightings;       ///< in the order in which they came; none: it was merged into another plane
    std::vector<std::size_t> seenThrough;  ///< stops that saw something behind it: it is glass, or has moved
};

/// The planes of a floor and the stops that saw them, in the frame of the first stop.
struct BuildingMap {
    std::vector<MapStop> stops;
    std::vector<MapPlane> planes;
};

/// Where a plane of the map was seen: the union of its sightings' outlines, in the map's frame.
std::vector<Outline::Polygon> fusedOutline(const BuildingMap& map, const MapPlane& plane);

}  // namespace planewright
