// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <span>

#include "core/planes/track_map.h"

namespace planewright {

/// The most likely plane of segments of different slices, in order; false where they do not determine one. A floor [m]
/// is what each may be off as a whole, beside its noise.
bool fitSegments(std::span<const SegmentNumber> numbers, const TrackMap& map, const Parameters& parameters,
                 double floor, PlaneEstimate& estimate);

}  // namespace planewright
