// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "core/formats/plane_result.h"
#include "core/types/angle.h"

namespace planewright {

/// A ceiling at 1.25 m: 4 m × 3 m with a square hole, of two segments, sigmas 0.5° and 2 mm.
inline PlaneResult sampleCeiling()
{
    auto plane = std::make_shared<Plane>();
    plane->id = 3;
    plane->normal = Eigen::Vector3d::UnitZ();
    plane->distance = 1.25;
    plane->fittingError = 0.5;
    plane->rms = 0.004;
    // Eigenvalues 1 and 0.25 along (0.6, 0.8) and across it, times (0.5°)².
    const double square = degrees(0.5) * degrees(0.5);
    plane->covariance << 0.52 * square, 0.36 * square, 0.0,  //
        0.36 * square, 0.73 * square, 0.0,                   //
        0.0, 0.0, 4e-6;
    plane->tangents << 1, 0,  //
        0, 1,                 //
        0, 0;
    plane->segments = {{4, 0}, {5, 1}};
    plane->points = 60;
    plane->bornStep = 4;
    plane->changedStep = 6;
    plane->lineage = {Lineage::Kind::Merged, {1, 2}};

    PlaneResult result;
    result.plane = plane;
    const double z = 1.25;
    result.outline.parts = {{{{0, 0, z}, {4, 0, z}, {4, 3, z}, {0, 3, z}},  //
                             {{{1, 1, z}, {1, 2, z}, {2, 2, z}, {2, 1, z}}}}};
    result.outline.area = 11.0;
    result.outline.width = 4.0;
    result.outline.height = 3.0;
    result.outline.centroid = {22.5 / 11.0, 1.5, z};  // (12 · 2 − 1 · 1.5) / 11
    result.name = "Ceiling, \"left\"";
    result.className = "ceiling";
    return result;
}

/// A wall at y = 2 of two triangular parts, split from plane 0, without covariance.
inline PlaneResult sampleWall()
{
    auto plane = std::make_shared<Plane>();
    plane->id = 12;
    plane->normal = Eigen::Vector3d::UnitY();
    plane->distance = 2.0;
    plane->fittingError = 1.0 / 3.0;
    plane->segments = {{4, 1}};
    plane->points = 7;
    plane->lineage = {Lineage::Kind::Split, {0}};

    PlaneResult result;
    result.plane = plane;
    result.outline.parts = {{{{0, 2, 0}, {0, 2, 1}, {1, 2, 0}}, {}}, {{{5, 2, 0}, {5, 2, -1}, {4, 2, 0}}, {}}};
    result.outline.area = 1.0;
    result.outline.width = 5.0;
    result.outline.height = 2.0;
    result.outline.centroid = {2.5, 2.0, 0.0};
    result.name = "=1+2";
    return result;
}

}  // namespace planewright
