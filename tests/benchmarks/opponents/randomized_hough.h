// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "core/types/angle.h"
#include "tests/benchmarks/opponents/labelled_points.h"
#include "tests/benchmarks/opponents/opponent.h"
#include "tests/benchmarks/opponents/voxel_grid.h"

namespace planewright {

struct RandomizedHoughParameters {
    ReductionParameters reduction{0.0, degrees(0.5)};
    double maxDistance = 6.0;      ///< largest distance between the three points of a vote, in spacings
    double cellAngle = 0.07;       ///< width of the accumulator's cells [rad]
    double cellSigmas = 4.0;       ///< and in distance, in standard deviations at the median range
    int votes = 5;                 ///< a cell with so many votes is a plane
    double toleranceSigmas = 2.5;  ///< largest distance of a plane's points, in standard deviations at the median range
    double gap = 5.0;  ///< a plane is one piece where gaps are below this, in spacings; 0 = gaps do not matter
    int misses = 20;   ///< candidates in a row without a plane after which none is left
    FinishParameters finish;
};

/// Randomised Hough transform with the ball accumulator (Borrmann, Elseberg, Lingemann and Nüchter 2011, algorithm 3)
/// on a voxel grid: three points that are near to one another vote for their plane; when a cell has votes enough, the
/// points on its plane are taken out and the votes forgotten.
class RandomizedHough : public Opponent {
public:
    explicit RandomizedHough(const RandomizedHoughParameters& parameters = {}) : parameters_(parameters) {}
    std::string_view name() const override { return "RHT"; }
    OpponentResult extract(const PointScan& scan) const override;

private:
    RandomizedHoughParameters parameters_;
};

}  // namespace planewright
