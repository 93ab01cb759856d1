// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "core/planes/track_map.h"

namespace planewright {

/// Grows a new plane over the slices between, before and after its first segments: it takes in the free segments that
/// face its own and fit it, and ends after a few slices without any. One that turns into a slice's own plane dissolves:
/// false.
bool growTrack(PlaneTrack& plane, TrackMap& map, const Parameters& parameters, StepRecorder& recorder);

/// Dissolves a plane that has turned into the slices that it is made of; false where it stays.
bool dropGrazing(PlaneTrack& plane, TrackMap& map, const Parameters& parameters, StepRecorder& recorder);

}  // namespace planewright
