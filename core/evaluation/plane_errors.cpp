// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/evaluation/plane_errors.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <Eigen/Geometry>

namespace planewright {

namespace {

ErrorSummary summaryOf(std::vector<double> values)
{
    if (values.empty())
        return {};
    std::sort(values.begin(), values.end());
    const std::size_t middle = values.size() / 2;
    const double median = values.size() % 2 == 1 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
    const double sum = std::accumulate(values.begin(), values.end(), 0.0);
    return {sum / static_cast<double>(values.size()), median, values.back()};
}

}  // namespace

PlaneDifference differenceOf(const ComparedPlane& a, const ComparedPlane& b)
{
    const double cosine = a.normal.dot(b.normal);
    const double side = cosine < 0.0 ? -1.0 : 1.0;
    return {std::atan2(a.normal.cross(b.normal).norm(), std::abs(cosine)), std::abs(a.distance - side * b.distance)};
}

PlaneErrors summarise(const std::vector<PlaneDifference>& differences)
{
    std::vector<double> angles;
    std::vector<double> distances;
    for (const PlaneDifference& difference : differences) {
        angles.push_back(difference.angle);
        distances.push_back(difference.distance);
    }
    return {differences.size(), summaryOf(std::move(angles)), summaryOf(std::move(distances))};
}

}  // namespace planewright
