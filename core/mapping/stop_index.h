// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <map>
#include <utility>
#include <vector>

#include <Eigen/Core>

namespace planewright {

/// Finds stops by where they stand, on a grid seen from above: the cost does not depend on how many there are
/// elsewhere.
class StopIndex {
public:
    /// `cell` [m] is the side of the grid's cells.
    explicit StopIndex(double cell) : cell_(cell) {}

    void add(std::size_t stop, const Eigen::Vector3d& place);
    void move(std::size_t stop, const Eigen::Vector3d& from, const Eigen::Vector3d& to);

    /// The stops nearest to a place in x and y, at most so many, none farther than `range` [m]; the nearest first.
    std::vector<std::size_t> nearest(const Eigen::Vector3d& place, std::size_t most, double range) const;

private:
    using Cell = std::pair<int, int>;
    struct Entry {
        std::size_t stop;
        Eigen::Vector2d place;
    };

    Cell cellOf(const Eigen::Vector3d& place) const;

    double cell_;
    std::map<Cell, std::vector<Entry>> cells_;
};

}  // namespace planewright
