// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <deque>
#include <vector>

#include "core/geometry/pose.h"

namespace planewright {

/// How far stops may have drifted against each other, along the ways by which they came into the map.
///
/// Each stop hangs on one that was there before. Errors of poses about the frame's origin, T ← exp(ξ) T, add up along
/// such a tree; so the covariance between two stops is that of the way over their nearest common ancestor. The last
/// loops that were closed are ways as well. More ways would only make it smaller: it is an upper bound. It costs the
/// logarithm of the number of stops.
class StopTree {
public:
    /// Adds a stop below another with the covariance of (θ, τ) at `place` [m] against it, in the map's axes. The first
    /// stop has no parent and no error.
    void addRoot();
    void add(std::size_t parent, const Eigen::Vector3d& place, const Matrix6d& covariance);

    std::size_t size() const { return nodes_.size(); }
    std::size_t parentOf(std::size_t stop) const { return nodes_[stop].parent; }
    std::size_t commonAncestor(std::size_t a, std::size_t b) const;

    /// Remembers that a loop was closed between two stops, with the covariance of (θ, τ) at `place` of what is left
    /// open.
    void link(std::size_t a, std::size_t b, const Eigen::Vector3d& place, const Matrix6d& covariance);

    /// Covariance of the drift between two stops, as (θ, τ) of what stands at `place`.
    Matrix6d between(std::size_t a, std::size_t b, const Eigen::Vector3d& place) const;

    /// True where the best way between two stops goes over a loop that was closed.
    bool isLinked(std::size_t a, std::size_t b, const Eigen::Vector3d& place) const;

    /// What each stop must be corrected by, as ξ about the origin, when `a` is found to be off by ξ against `b`: the
    /// most likely errors along the way between them. Stops that hang on the way move with it.
    std::vector<Vector6d> corrections(std::size_t a, std::size_t b, const Vector6d& drift) const;

private:
    struct Node {
        std::size_t parent = 0;
        std::size_t jump = 0;  ///< an ancestor far up (Myers 1983)
        std::size_t depth = 0;
        Matrix6d covariance = Matrix6d::Zero();  ///< about the origin, against the first stop
    };

    struct Link {
        std::size_t a = 0;
        std::size_t b = 0;
        Matrix6d covariance = Matrix6d::Zero();  ///< about the origin
    };
    struct Way {
        Matrix6d covariance = Matrix6d::Zero();  ///< at the place asked for
        bool isLinked = false;
    };

    Matrix6d along(std::size_t a, std::size_t b) const;
    Way bestWay(std::size_t a, std::size_t b, const Eigen::Vector3d& place) const;

    std::vector<Node> nodes_;
    std::deque<Link> links_;  ///< the last ones
};

}  // namespace planewright
