// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

namespace planewright {

/// The ball accumulator of Borrmann, Elseberg, Lingemann and Nüchter (2011): votes for planes by the direction of their
/// normal and their distance from the origin.
///
/// Bands of latitude are divided into as many pieces as their circumference needs, so that all cells cover about the
/// same part of the sphere and none is favoured; the normal points away from the origin, so that distances are not
/// negative. Each cell keeps the sum of its votes, whose mean is finer than the cell.
class BallAccumulator {
public:
    struct Cell {
        int votes = 0;
        Eigen::Vector3d normals = Eigen::Vector3d::Zero();  ///< sum over the votes
        double distances = 0.0;                             ///< sum over the votes [m]
    };

    /// Cells of this width [rad, m] for planes up to this distance [m].
    BallAccumulator(double angle, double distanceStep, double maxDistance);

    /// Votes for a plane n·p = d with d ≥ 0; gives the cell after the vote. Planes too far away have none.
    const Cell* vote(const Eigen::Vector3d& normal, double distance);

    /// Forgets all votes.
    void clear();

private:
    int bands_;
    double distanceStep_;
    std::size_t distances_;
    std::vector<int> pieces_;       // of each band
    std::vector<int> firstOfBand_;  // number of a band's first piece
    std::vector<int> slots_;        // place in cells_ of each cell, or −1
    std::vector<std::size_t> used_;
    std::vector<Cell> cells_;
};

}  // namespace planewright
