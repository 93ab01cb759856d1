// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include "core/planes/track_map.h"
#include "core/types/why_not.h"

namespace planewright {

/// Beams that two segments of neighbouring slices may miss each other by and still overlap.
inline constexpr int kOverlapMargin = 3;
/// Beams within which segments of two planes count as side by side.
inline constexpr int kSideMargin = 20;

/// Gives each segment of the newest slice to the plane that it fits best (section 4.1.4, Table III): of the planes of
/// the segments it faces in the slices before, or else of the well-known planes seen lately. Returns those left over,
/// which the map keeps until the next slice.
const std::vector<SegmentNumber>& joinTracks(TrackMap& map, const Parameters& parameters, StepRecorder& recorder);

/// Makes planes of segments that belong to none, of slices from `firstSlice` on (section 4.3, Table V): three segments
/// that face each other in three slices suggest a plane; the best supported come first and grow over the segments that
/// they meet.
void seedTracks(TrackMap& map, int firstSlice, const Parameters& parameters, StepRecorder& recorder);

/// Dissolves planes of few slices that have turned into the slices that they are made of.
void dropYoungGrazing(TrackMap& map, const Parameters& parameters, StepRecorder& recorder);

/// Makes planes of two facing segments of neighbouring slices, where three were not to be had; only for the last pass.
void seedPairs(TrackMap& map, const Parameters& parameters, StepRecorder& recorder);

/// Gives leftover segments of slices from `firstSlice` on another chance (Table I line 10).
void joinRemaining(TrackMap& map, int firstSlice, const Parameters& parameters, StepRecorder& recorder);

/// The ways in which a segment may come to a plane, as things are: it faces it, or the plane is known well.
std::vector<Conditions> waysIntoTrack(SegmentNumber number, PlaneTrack& plane, TrackMap& map,
                                      const Parameters& parameters);

/// How a segment may move in the last pass from the plane that it belongs to to one that it faces.
Conditions wayToMove(SegmentNumber number, PlaneTrack& plane, TrackMap& map, const Parameters& parameters);

/// Merges planes that are one (section 4.4, Table VII lines 9 to 13).
void mergeTracks(TrackMap& map, const Parameters& parameters, StepRecorder& recorder);

/// The conditions on which two planes are merged, all of them, as they are.
Conditions mergeConditions(const PlaneTrack& a, const PlaneTrack& b, TrackMap& map, const Parameters& parameters);

/// Lets segments go that do not fit their plane, to a neighbour's plane or to none (section 4.4, Table VII lines 1 to
/// 8): what leaves may make planes of its own.
void splitTracks(TrackMap& map, const Parameters& parameters, StepRecorder& recorder);

/// Takes planes apart of which too large a share is on runs that lean out of them (`contestedShare`), into the planes
/// of these runs: a stair is its risers, not the slope over their edges.
void splitContested(TrackMap& map, const Parameters& parameters, StepRecorder& recorder);

/// By how much a plane's covariance grows where its segments scatter by more than their noise: so does the plane.
double scatterOf(const PlaneTrack& plane);

/// Takes planes apart whose parts, which lie apart from each other, would not be merged: each part that is not one with
/// the others becomes a plane of its own. Few segments in each of two places lie in many planes; only when all are
/// there do they tell that it is none.
void splitParts(TrackMap& map, const Parameters& parameters, StepRecorder& recorder);

/// Gives segments of a slice that decide where their plane lies to a plane that they face and that foretells them
/// better than the others of their own do: the line of a slice on the floor lies in the plane of a jamb that stands
/// there as well, and would turn it by degrees.
void settleDecisive(TrackMap& map, const Parameters& parameters, StepRecorder& recorder);

/// Takes the worst segments out of small planes that explain theirs badly, until they explain the rest well.
void thinTracks(TrackMap& map, const Parameters& parameters, StepRecorder& recorder);

/// Dissolves planes that are too small, too narrow or not flat.
void dropUnfounded(TrackMap& map, const Parameters& parameters, StepRecorder& recorder);

/// The last fit of every plane, over the segments that fit it.
void refineTracks(TrackMap& map, const Parameters& parameters);

}  // namespace planewright
