// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "core/planes/track_map.h"

namespace planewright {

/// Share of a plane's points that are on runs that lean out of it; 0 for a plane that explains its segments.
///
/// A run is three segments that face each other in slices that follow each other. It leans out if a plane of its own
/// is turned by more than `planes.run-lean`, and explains the run better than the whole plane does by more than chance.
/// Explained is what was measured, the ranges: a plane met at a shallow angle lets them stray by centimetres where a
/// steep one lets them stray by millimetres, so the slope over the edges of a stair, to which all segments are near,
/// explains less than its risers do. A wall that is wavy does not turn that far.
double contestedShare(const PlaneTrack& plane, const TrackMap& map, const Parameters& parameters);

}  // namespace planewright
