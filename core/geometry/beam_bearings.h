// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>
#include <vector>

#include "core/geometry/cloud_scan.h"
#include "core/types/beam_table.h"
#include "core/types/error.h"

namespace planewright {

/// A slice of a cloud with the bearings of its points about the pitch axis.
struct SeenBearings {
    double tilt = 0.0;             ///< [rad]
    std::vector<double> bearings;  ///< of each point [rad]
    CloudSlice* slice = nullptr;   ///< whose points have their beams' numbers
};

/// Gives the points of all slices the numbers of evenly spaced beams, and says how many beams there are. The step is
/// what most neighbouring points are apart. Errors (Unreadable): points that are not so, and limits of a recording.
Result<int> numberBeams(std::vector<SeenBearings>& slices);

/// Where the beams of a scanner lie.
struct BeamBearings {
    double first = 0.0;                      ///< [rad]
    double step = 0.0;                       ///< [rad]; the mean where there is a table
    std::shared_ptr<const BeamTable> table;  ///< where they are not evenly spaced
};

/// The bearings that are nearest to those of all points: evenly spaced, of each beam the mean, or those of a flat
/// image. Errors (Unreadable): they do not rise from beam to beam, or are of less than two beams.
Result<BeamBearings> layBearings(const std::vector<SeenBearings>& slices, int beams);

}  // namespace planewright
