// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "tests/benchmarks/opponents/labelled_points.h"
#include "tests/benchmarks/opponents/opponent.h"
#include "tests/benchmarks/opponents/voxel_grid.h"

namespace planewright {

struct ProsacOnlyParameters {
    ReductionParameters reduction{4.75, 0.0};
    double toleranceSigmas = 3.0;  ///< largest distance of an inlier, in standard deviations at the median range
    int iterations = 1000;         ///< most hypotheses of a plane
    FinishParameters finish{1.5, 0.1, 3.0};
};

/// PROSAC_Only of the paper (section 5.3): voxel grid filter, then again and again the best-supported plane by PCL's
/// ProgressiveSampleConsensus, without normals, until none is left that is large enough.
class ProsacOnly : public Opponent {
public:
    explicit ProsacOnly(const ProsacOnlyParameters& parameters = {}) : parameters_(parameters) {}
    std::string_view name() const override { return "PROSAC_Only"; }
    OpponentResult extract(const PointScan& scan) const override;

private:
    ProsacOnlyParameters parameters_;
};

}  // namespace planewright
