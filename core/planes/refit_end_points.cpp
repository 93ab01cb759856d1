// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <numeric>

#include "core/planes/refit_methods.h"
#include "core/planes/split_and_merge.h"

namespace planewright {

namespace {

SegmentTable tableOf(const SegmentSlices& slices)
{
    SegmentTable table;
    for (const SegmentSlice& slice : slices)
        table.append(slice.step, slice.segments);
    return table;
}

std::vector<SegmentNumber> allOf(const SegmentTable& table)
{
    std::vector<SegmentNumber> all(static_cast<std::size_t>(table.size()));
    std::iota(all.begin(), all.end(), 0);
    return all;
}

Plane planeOf(const PlaneFit& fit, const std::vector<SegmentNumber>& members, const SegmentTable& table,
              const Refit& refit)
{
    GrowingPlane plane(kNoPlane, fit, members, table, refit.parameters.planes, 0);
    plane.refine(table, refit.parameters.planes, 0);
    return *plane.publish(table);
}

}  // namespace

std::optional<Plane> refitEndPoints(const SegmentSlices& slices, const Refit& refit)
{
    const SegmentTable table = tableOf(slices);
    const std::vector<SegmentNumber> all = allOf(table);
    if (all.size() < 2)
        return std::nullopt;
    WeightedSums sums;
    for (const EndPoint& point : endPointsOf(all, table))
        sums.add(point.position, 1.0);
    const Plane plane = planeOf(fitPlane(sums, Eigen::Vector3d::UnitZ()), all, table, refit);
    if (!plane.normal.allFinite() || plane.covariance.isZero(0.0))
        return std::nullopt;
    return plane;
}

std::vector<Plane> searchEndPoints(const SegmentSlices& slices, const Refit& refit)
{
    const SegmentTable table = tableOf(slices);
    std::vector<SegmentNumber> left = allOf(table);
    std::vector<Plane> planes;
    for (const FoundPlane& part : partsOf(left, table, refit.parameters.planes))
        planes.push_back(planeOf(part.fit, part.members, table, refit));
    return planes;
}

}  // namespace planewright
