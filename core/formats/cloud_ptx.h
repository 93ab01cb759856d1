// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <iosfwd>
#include <string>

#include "core/geometry/cloud_scan.h"
#include "core/types/error.h"

namespace planewright {

/// Reads one scan, from 0, of a Leica PTX text, which may hold several one after another.
///
/// A scan begins with ten lines: columns; rows; the scanner's registered place and its three axes, which are checked
/// and not used; and four lines of a matrix that places the scan: x' = x r11 + y r21 + z r31 + tr1 and so on, so that
/// its rows are what the axes become and the last is the translation. That is the scan's pose. Then follow columns ×
/// rows points `x y z intensity [red green blue]`, column after column, in metres in the scanner's own frame, z up; 0 0
/// 0 is no return. A column is a slice, a row a beam. Blank lines between scans are passed over; the text may be
/// compressed with gzip.
///
/// Errors (Unreadable) name file and line: counts that are none, a matrix that is no rotation with a translation, to
/// 1e-3, a point that is none, a scan that is cut short, points farther than 1 km, and what a recording cannot hold.
/// Only the scan that is asked for is looked at as a whole; Usage where there are not so many.
Result<CloudScan> readCloudPtx(std::istream& in, const std::string& fileName, int scan);

/// How many scans there are: their headers and numbers of lines are checked. Errors as above.
Result<int> scansOfPtx(std::istream& in, const std::string& fileName);

}  // namespace planewright
