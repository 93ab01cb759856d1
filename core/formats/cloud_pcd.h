// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <iosfwd>
#include <string>

#include "core/geometry/cloud_scan.h"
#include "core/types/error.h"

namespace planewright {

/// Reads an organised cloud of the Point Cloud Library (.pcd 0.6 and 0.7; ascii, binary, binary_compressed): a row is a
/// slice, a column a beam. Only x, y, z are used, which are of type F and in metres; a coordinate that is no finite
/// number, and a point at the sensor, are no return.
///
/// The sensor is at the VIEWPOINT's place in the cloud's frame, as PCL takes it for normals; where that is not the
/// origin it is the scan's pose. The VIEWPOINT's rotation is not used: files have all kinds there. A cloud that is all
/// before z = 0 and looks along z on the mean, to 45°, is in a camera's frame (x right, y down, z ahead) and is turned
/// to ours, and a note says so; any other is taken as x right, y forward, z up.
///
/// PCL's own reader is not used: it sizes its buffers by what the header says, throws, asks for exact line layouts
/// that other writers do not keep, and is as large as all of this program. Here nothing is sized by a header before the
/// bytes are there, and LZF, whose library has had no release since 2011, is decoded with every index checked.
///
/// Errors (Unreadable) name file and line or byte: a header that is not complete, repeats itself or contradicts itself,
/// a cloud that is not organised, more than kMaxSlices rows, kMaxBeams columns or kMaxRanges points, data that are too
/// short, too long or damaged, and points farther than 1 km.
Result<CloudScan> readCloudPcd(std::istream& in, const std::string& fileName);

}  // namespace planewright
