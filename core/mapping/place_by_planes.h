// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/geometry/pose.h"
#include "core/mapping/uncertain_plane.h"
#include "core/types/angle.h"

namespace planewright {

/// A plane for a search of the place: its parameters and how large it was seen.
struct WeighedPlane {
    UncertainPlane parameters;
    double area = 0.0;  ///< [m²]
};

/// Where a stop may be looked for.
struct PlacementSearch {
    std::optional<Pose> about;   ///< where it is expected; the heading is not taken from it
    double reach = 1e9;          ///< how far from there it may stand [m]
    double tilt = degrees(5.0);  ///< how far from upright it may stand [rad]; π for any attitude
};

/// True where a stop's plane and a plane of the map, by their numbers, were seen in places that touch at a pose.
using PlanesMeet = std::function<bool(std::size_t seen, std::size_t known, const Pose& pose)>;

/// A pose that a stop may have by its planes alone.
struct Placement {
    Pose pose;
    Matrix6d covariance = Matrix6d::Identity();
    std::vector<std::pair<std::size_t, std::size_t>> pairs;  ///< (seen, known)
    /// The pairs fix all of the pose, and would without any one of them, so that each is vouched for by the others.
    bool fixed = false;
};

/// Places a stop by its planes alone: rotations from pairs of planes at equal angles, shifts from triples, then the
/// largest set of pairs that fit together and meet. The best first; at most eight, no two of them alike. More than one
/// with about as many pairs as the first means that the planes do not tell which.
///
/// The work is bounded: `known` beyond a few hundred planes should be cut down to those in reach.
std::vector<Placement> placeByPlanes(std::span<const WeighedPlane> seen, std::span<const WeighedPlane> known,
                                     const PlacementSearch& search, const PlanesMeet& meet);

/// True where two poses are the same place to a search: within 3° and 20 cm.
bool isSamePlace(const Pose& a, const Pose& b);

}  // namespace planewright
