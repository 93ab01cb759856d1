// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "core/types/angle.h"
#include "tests/benchmarks/opponents/labelled_points.h"
#include "tests/benchmarks/opponents/opponent.h"

namespace planewright {

struct OrganizedPlanesParameters {
    double windowTilt = degrees(1.16);    ///< how far a normal's window reaches to both sides, one slice at least [rad]
    double windowBearing = degrees(1.5);  ///< and across, one beam at least [rad]
    double angle = 0.05;                  ///< largest angle between the normals of neighbours on one plane [rad]
    double distanceSigmas = 3.0;  ///< largest distance of a neighbour from the plane of a point, in standard deviations
    double refineSigmas = 2.0;    ///< the same when planes are grown into their surroundings afterwards
    double maxCurvature = 0.005;  ///< largest smallest eigenvalue of a plane's scatter, as a share of all three
    double least = 1.0;           ///< least returns of a piece, in smallest planes worth finding
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
