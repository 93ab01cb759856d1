// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "tests/benchmarks/opponents/labelled_points.h"
#include "tests/benchmarks/opponents/opponent.h"
#include "tests/benchmarks/opponents/voxel_grid.h"

namespace planewright {

struct EfficientRansacParameters {
    ReductionParameters reduction{4.75, 0.0};
    int neighbours = 8;            ///< points that a normal is estimated from
    double toleranceSigmas = 1.5;  ///< epsilon, in standard deviations at the median range
    double gap = 3.0;              ///< cluster_epsilon, in spacings
    double normalAngle = 0.3;      ///< largest angle of a point's normal to the plane's [rad]
    int minPoints = 20;            ///< least voxels of a plane
    double probability = 0.01;     ///< of missing the largest plane
    FinishParameters finish;
};

/// Efficient RANSAC (Schnabel, Wahl and Klein 2007) of CGAL on a voxel grid, least squares over all points after.
class EfficientRansac : public Opponent {
public:
    explicit EfficientRansac(const EfficientRansacParameters& parameters = {}) : parameters_(parameters) {}
    std::string_view name() const override { return "CGAL Efficient RANSAC"; }
    OpponentResult extract(const PointScan& scan) const override;

private:
    EfficientRansacParameters parameters_;
};

}  // namespace planewright
