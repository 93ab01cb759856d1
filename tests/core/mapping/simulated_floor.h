// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "core/geometry/pose.h"
#include "core/mapping/stop.h"
#include "core/simulation/random.h"

namespace planewright {

/// A flat piece of surface that is seen from one side.
struct Face {
    int plane = 0;  ///< in FloorPlan::planes
    Eigen::Vector3d corner = Eigen::Vector3d::Zero();
    Eigen::Vector3d edgeU = Eigen::Vector3d::UnitX();
    Eigen::Vector3d edgeV = Eigen::Vector3d::UnitY();
};

/// An oriented plane that is there: the normal points away from the side that is seen.
struct OrientedPlane {
    Eigen::Vector3d normal;
    double distance;
};

/// The surfaces of a floor. Faces that lie in one plane and are seen from one side belong to one plane.
class FloorPlan {
public:
    /// A face of a wall from a to b, seen from the left of that way.
    void addWall(const Eigen::Vector2d& a, const Eigen::Vector2d& b, double bottom, double top);

    /// A level rectangle: a floor is seen from above, a ceiling from below.
    void addLevel(const Eigen::Vector2d& low, const Eigen::Vector2d& high, double height, bool seenFromAbove);

    /// A box on the ground, turned about its middle.
    void addBox(const Eigen::Vector2d& middle, const Eigen::Vector2d& size, double height, double turn);

    /// A wall of some thickness with doors of 0.9 m × 2.1 m whose middles lie at these shares of the way from a to b;
    /// the face from a to b is seen from the left, the other one lies to the right. A closed door fills the wall's far
    /// side.
    void addWallWithDoors(const Eigen::Vector2d& a, const Eigen::Vector2d& b, double top, double thickness,
                          const std::vector<double>& doors, bool closed = false);

    const std::vector<Face>& faces() const { return faces_; }
    const std::vector<OrientedPlane>& planes() const { return planes_; }

private:
    void addFace(const Eigen::Vector3d& corner, const Eigen::Vector3d& edgeU, const Eigen::Vector3d& edgeV,
                 const Eigen::Vector3d& normal);

    std::vector<Face> faces_;
    std::vector<OrientedPlane> planes_;
};

/// A ring of corridors, 20 m × 10 m along its middle, with rooms behind doors on all sides, pillars, cupboards and a
/// slanted wall; the seed varies them.
FloorPlan ringFloor(std::uint64_t seed);

/// Where stops stand on the ring's middle: one every few metres, the last one next to the first.
std::vector<Pose> ringRoute(int stops, std::uint64_t seed);

/// What a stop saw, and what is true of it.
struct SimulatedStop {
    Stop stop;
    Pose truth;               ///< in the frame of the plan
    std::vector<int> planes;  ///< of the plan, for each plane of the stop
};

/// How stops see.
struct SightNoise {
    int rays = 6000;
    double range = 0.010;        ///< standard deviation [m]
    double pointsPerRay = 16.0;  ///< a scan has so many times more points
    double angle = 1.7e-4;       ///< of a plane's normal, however many points: 0.01° [rad]
    double distance = 5e-4;      ///< of a plane's distance, however many points [m]
    double reach = 20.0;         ///< longest range [m]
    double odometryScale = 1.0;  ///< the errors of odometry, in units of what is told
};

/// Sees the floor from each place: rays in all directions, planes with enough of them, with errors drawn from the
/// covariances that are told; and odometry likewise.
std::vector<SimulatedStop> seeFloor(const FloorPlan& plan, const std::vector<Pose>& route, const SightNoise& noise,
                                    std::uint64_t seed);

/// What one stop sees, without odometry.
SimulatedStop seeFrom(const FloorPlan& plan, const Pose& pose, const SightNoise& noise, Random& random);

/// An error drawn from a covariance.
Eigen::VectorXd drawn(const Eigen::MatrixXd& covariance, Random& random);

}  // namespace planewright
