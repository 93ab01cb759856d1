// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "core/planes/refit_segments.h"
#include "core/planes/segment_slices.h"

namespace planewright {

/// refitPlane and searchPlanes by end points (`method.estimator=end-points`): refined over all (Table VI), or searched
/// as splitPlanes does.
std::optional<Plane> refitEndPoints(const SegmentSlices& slices, const Refit& refit);
std::vector<Plane> searchEndPoints(const SegmentSlices& slices, const Refit& refit);

/// The same by likelihood: the last fit of the extraction, or its last pass over the segments alone.
std::optional<Plane> refitTracks(const SegmentSlices& slices, const Refit& refit);
std::vector<Plane> searchTracks(const SegmentSlices& slices, const Refit& refit);

}  // namespace planewright
