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

}  // namespace planewright
