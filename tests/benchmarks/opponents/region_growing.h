// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "tests/benchmarks/opponents/labelled_points.h"
#include "tests/benchmarks/opponents/opponent.h"
#include "tests/benchmarks/opponents/voxel_grid.h"

namespace planewright {

struct RegionGrowingParameters {
    ReductionParameters reduction{3.5, 0.0};
    int normalNeighbours = 16;  ///< points that a normal is estimated from
    int neighbours = 18;        ///< points that a region may grow to from one
    double toleranceSigmas =
        3.0;                   ///< largest distance to the region's plane, in standard deviations at the median range
    double normalAngle = 0.6;  ///< largest angle of a point's normal to the plane's [rad]
    int minPoints = 20;        ///< least voxels of a plane
    FinishParameters finish;
};

/// Region growing on a point set (Lafarge and Mallet 2012) of CGAL on a voxel grid, seeds on flat neighbourhoods first,
/// least squares over all points after.
class RegionGrowing : public Opponent {
public:
    explicit RegionGrowing(const RegionGrowingParameters& parameters = {}) : parameters_(parameters) {}
    std::string_view name() const override { return "CGAL region growing"; }
    OpponentResult extract(const PointScan& scan) const override;

private:
    RegionGrowingParameters parameters_;
};

}  // namespace planewright
