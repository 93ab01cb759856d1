// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <iosfwd>
#include <string>

#include "core/geometry/cloud_scan.h"
#include "core/types/error.h"

namespace planewright {

/// Reads a scan of 3DTK's format `uos` (scanNNN.3d): a point `x y z` a line, in centimetres, x right, y up, z ahead, in
/// the order of measurement; values after these, three or four at most as `uosr` and `uos_rgb` have them, are not used.
/// Before the first point there may be a line of the form `180 x 256`, which says nothing that counts, and lines that
/// begin with #. A point at the origin is no return. Slices are what splitSweeps makes of the points, whose beams have
/// no numbers.
///
/// Errors (Unreadable) name file and line: a point that is none or has another number of values than the first, points
/// farther than 1 km, no point at all, and more than kMaxRanges points or kMaxSlices slices.
Result<CloudScan> readCloudUos(std::istream& in, const std::string& fileName);

/// Reads the pose beside such a scan (scanNNN.pose): x, y, z in centimetres and the angles about x, y and z in degrees,
/// R = Rx Ry Rz, in the same frame, which is left-handed; and turns it into ours. Errors (Unreadable): anything but six
/// numbers.
Result<Pose> readPoseUos(std::istream& in, const std::string& fileName);

}  // namespace planewright
