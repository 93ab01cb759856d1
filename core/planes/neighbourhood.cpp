// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/planes/neighbourhood.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace planewright {

bool faceEachOther(const LineSegment& a, const LineSegment& b)
{
    if (std::abs(a.id.step - b.id.step) > kNeighbourSlices)
        return false;
    const LineSegment& left = a.firstBeam <= b.firstBeam ? a : b;
    const LineSegment& right = a.firstBeam <= b.firstBeam ? b : a;
    return right.firstBeam <= left.lastBeam || (left.endShadowed && right.startShadowed);
}

double segmentDistance(const LineSegment& a, const LineSegment& b)
{
    const Eigen::Vector3d alongA = a.end - a.start;
    const Eigen::Vector3d alongB = b.end - b.start;
    const Eigen::Vector3d between = a.start - b.start;
    const double aa = alongA.squaredNorm();
    const double bb = alongB.squaredNorm();
    const double ab = alongA.dot(alongB);
    const double ad = alongA.dot(between);
    const double bd = alongB.dot(between);
    const double denominator = aa * bb - ab * ab;
    const double free = denominator > 1e-12 * aa * bb ? std::clamp((ab * bd - ad * bb) / denominator, 0.0, 1.0) : 0.0;
    // The nearest point of b to that of a, then of a to that of b: exact unless both are clamped, then within a hair.
    const double onB = std::clamp((ab * free + bd) / bb, 0.0, 1.0);
    const double onA = std::clamp((ab * onB - ad) / aa, 0.0, 1.0);
    return (between + onA * alongA - onB * alongB).norm();
}

}  // namespace planewright
