// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "core/geometry/cloud_scan.h"
#include "core/types/error.h"
#include "core/types/recording.h"

namespace planewright {

/// Recovers the scanner that a scan was measured with from its points: the pitch axis that the planes of all slices go
/// through, the pitch of each slice, and the bearing of each beam. The axis goes through the scanner (no lever arm).
///
/// The bearings are evenly spaced where that holds to 1e-5 rad, else a BeamTable: the same in all slices, or those of a
/// flat image, whichever is nearer to the points. A beam without a return in any slice lies evenly between its
/// neighbours. Points without numbers are given theirs, on an even spacing of bearings, and get them in `cloud`; of a
/// scanner that sweeps to and fro, slices are turned round to where bearings rise. A slice without returns has no pitch
/// and is a missing step. How near the points lie to this is for the caller to measure.
///
/// Errors (Unreadable, without the file's name): fewer than two slices with points off one plane, and bearings that do
/// not rise from beam to beam. kMaxSlices, kMaxBeams and kMaxRanges hold.
Result<Recording> recoverScanner(CloudScan& cloud);

}  // namespace planewright
