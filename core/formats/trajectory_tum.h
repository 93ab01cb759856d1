// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <iosfwd>
#include <span>
#include <string>
#include <vector>

#include "core/geometry/pose.h"
#include "core/types/error.h"

namespace planewright {

/// A pose of a trajectory, and when it was.
struct StampedPose {
    double time = 0.0;  ///< [s]; of stops that nobody timed, their number
    Pose pose;
};

/// Most poses of a trajectory that is read.
inline constexpr std::size_t kMaxPoses = 1'000'000;

/// Reads a trajectory in the format of the TUM RGB-D benchmark: `timestamp tx ty tz qx qy qz qw` a line, metres,
/// separated by blanks; lines that begin with # and empty ones are passed over.
///
/// Times rise or are equal. Quaternions of length 1 within 1e-3 are made so exactly. Errors (Unreadable) name file,
/// line and value.
Result<std::vector<StampedPose>> readTrajectoryTum(std::istream& in, const std::string& fileName);

/// Writes a trajectory in that format, with qw ≥ 0. Errors: NotWritten.
Result<void> writeTrajectoryTum(std::ostream& out, std::span<const StampedPose> poses);

}  // namespace planewright
