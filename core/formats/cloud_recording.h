// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

#include "core/geometry/cloud_scan.h"
#include "core/types/error.h"
#include "core/types/recording.h"

namespace planewright {

/// How far a point may be off the recovered scanner, as an angle [rad]: 1 mm on each metre, beside the rounding of a
/// range to whole millimetres.
inline constexpr double kRecoveryTolerance = 1e-3;

/// A cloud as a recording.
struct CloudRecording {
    Recording recording;
    double largestOff = 0.0;        ///< of a point from where the recording has it [m]
    double rmsOff = 0.0;            ///< root of the mean square of that over all points [m]
    std::size_t points = 0;         ///< that are in it
    std::size_t pointsLeftOut = 0;  ///< they are farther off than the tolerance
};

/// Makes a recording of a cloud: the scanner that recoverScanner finds, with ranges, angles and bearings as files hold
/// them, so that the recording is the same, bit for bit, after it was written and read. Its extra keys tell people what
/// was recovered and how well: `recovered_axis`, `recovered_beams`, `recovered_largest_off_mm`, `recovered_rms_off_mm`,
/// and the cloud's notes.
///
/// Errors (Unreadable), beginning with `place`: no scanner is found, or more than one point in a thousand is off by
/// more than the tolerance, which tells where its slices are not planar rows through a common axis.
Result<CloudRecording> recordingOf(CloudScan cloud, const std::string& place);

}  // namespace planewright
