// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "tests/benchmarks/opponents/labelled_points.h"
#include "tests/benchmarks/opponents/opponent.h"

namespace planewright {

struct OrganizedPlanesParameters {
    int windowSlices = 1;         ///< a normal's window reaches so many slices before and after
    int windowBeams = 6;          ///< and so many beams to both sides
    double angle = 0.05;          ///< largest angle between the normals of neighbours on one plane [rad]
    double distanceSigmas = 3.0;  ///< largest distance of a neighbour from the plane of a point, in standard deviations
    double refineSigmas = 3.0;    ///< the same when planes are grown into their surroundings afterwards
    double maxCurvature = 0.02;   ///< largest smallest eigenvalue of a plane's scatter, as a share of all three
    double least = 0.7;           ///< least returns of a piece, in smallest planes worth finding
    FinishParameters finish;
};

/// OrganizedMultiPlaneSegmentation of PCL (Trevor, Gedikli, Rusu and Christensen 2013) on the grid of slices and beams.
///
/// PCL's depth is a coordinate, which has no meaning for a scanner that looks all round: normals are estimated from
/// windows of the grid within a jump of range, and the comparator takes distances in standard deviations.
class OrganizedPlanes : public Opponent {
public:
    explicit OrganizedPlanes(const OrganizedPlanesParameters& parameters = {}) : parameters_(parameters) {}
    std::string_view name() const override { return "PCL organized planes"; }
    OpponentResult extract(const PointScan& scan) const override;

private:
    OrganizedPlanesParameters parameters_;
};

}  // namespace planewright
