// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/planes/refit_segments.h"

#include <algorithm>

#include "core/planes/refit_methods.h"

namespace planewright {

std::optional<Plane> refitPlane(std::span<const SegmentId> segments, const Refit& refit)
{
    const SegmentSlices slices = slicesOf(segments, refit.snapshot.segments, refit.description);
    if (refit.parameters.method.estimator == Estimator::Likelihood)
        return refitTracks(slices, refit);
    return refitEndPoints(slices, refit);
}

std::vector<Plane> searchPlanes(std::span<const SegmentId> segments, const Refit& refit)
{
    const SegmentSlices slices = slicesOf(segments, refit.snapshot.segments, refit.description);
    std::vector<Plane> planes = refit.parameters.method.estimator == Estimator::Likelihood
                                    ? searchTracks(slices, refit)
                                    : searchEndPoints(slices, refit);
    std::stable_sort(planes.begin(), planes.end(), [](const Plane& a, const Plane& b) { return a.points > b.points; });
    return planes;
}

}  // namespace planewright
