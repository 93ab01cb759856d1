// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <vector>

#include "core/geometry/pose.h"
#include "core/simulation/scene.h"
#include "core/simulation/scene_builder.h"

namespace planewright {

/// A place of a route where the scanner stops. Each floor has a frame of its own: x and y as in all others, z from its
/// floor up [m].
struct BuildingStop {
    int floor = 0;
    Pose pose;      ///< in the frame of its floor
    Pose odometry;  ///< where wheels tell it to be; the first stop of each floor is the frame of that
};

/// A building of floors around a core: a ring of corridors, 20 m × 10 m along its middle, with rooms behind open doors
/// all around it, cupboards, pillars, and in the core a stairwell that goes through all floors. Walls of core, shell
/// and stairwell stand above each other; rooms, doors and furniture are each floor's own, by the seed. A floor is open
/// over the flight that leads up to it, which is seen from both.
class SimulatedBuilding {
public:
    static constexpr double kStoreyHeight = 3.2;  ///< from floor to floor [m]

    SimulatedBuilding(int floors, std::uint64_t seed);

    int floors() const { return static_cast<int>(floors_.size()); }

    /// A floor as a scanner at this pose sees it, which also tells the true planes; their ids are the same from
    /// everywhere on the floor.
    Scene sceneAt(int floor, const Pose& pose) const;

    /// So many stops, once round the ring of each floor, from the lowest up; the last of a floor is next to its first.
    /// Where there are several floors, the first of each is in front of the stairs and looks at them; from there it
    /// goes round.
    /// Odometry has the errors of OdometryNoise for each motion, and neither height nor tilt. Needs a stop for each
    /// floor at least.
    std::vector<BuildingStop> route(int stops) const;

private:
    std::uint64_t seed_;
    std::vector<SceneBuilder> floors_;
};

}  // namespace planewright
