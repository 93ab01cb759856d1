// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "core/types/angle.h"
#include "tests/benchmarks/opponents/labelled_points.h"
#include "tests/benchmarks/opponents/opponent.h"
#include "tests/benchmarks/opponents/voxel_grid.h"

namespace planewright {

struct ProsacNormalParameters {
    ReductionParameters reduction{0.0, degrees(0.5)};
    int neighbours = 10;         ///< voxels that a normal is estimated from
    double clusterAngle = 0.35;  ///< largest angle of a normal to its cluster's direction [rad]
    double gap = 2.0;  ///< a cluster is one piece where gaps are below this, in spacings; 0 = gaps do not matter
    double toleranceSigmas = 3.0;  ///< largest distance of an inlier, in standard deviations at the median range
    int iterations = 500;          ///< most hypotheses of a plane
    FinishParameters finish{1.5, 0.1, 3.0};
};

/// PROSAC_Normal of the paper (section 5.3): voxel grid filter, PCL's normals, clusters of like normals, and in each
/// cluster again and again the best-supported plane by PCL's ProgressiveSampleConsensus, points on flat neighbourhoods
/// first.
class ProsacNormal : public Opponent {
public:
    explicit ProsacNormal(const ProsacNormalParameters& parameters = {}) : parameters_(parameters) {}
    std::string_view name() const override { return "PROSAC_Normal"; }
    OpponentResult extract(const PointScan& scan) const override;

private:
    ProsacNormalParameters parameters_;
};

}  // namespace planewright
