// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/types/line_segment.h"

namespace planewright {

PointMoments& PointMoments::operator+=(const PointMoments& other)
{
    if (other.count == 0.0)
        return *this;
    const double total = count + other.count;
    const Eigen::Vector3d gap = other.mean - mean;
    scatter += other.scatter + (count * other.count / total) * gap * gap.transpose();
    mean += (other.count / total) * gap;
    count = total;
    return *this;
}

void turn(LineSegment& segment, const Eigen::Matrix3d& rotation)
{
    for (Eigen::Vector3d* vector :
         {&segment.start, &segment.end, &segment.direction, &segment.viewpoint, &segment.moments.mean})
        *vector = (rotation * *vector).eval();
    for (Eigen::Matrix3d* matrix : {&segment.startCovariance, &segment.endCovariance, &segment.moments.scatter})
        *matrix = (rotation * *matrix * rotation.transpose()).eval();
}

}  // namespace planewright
