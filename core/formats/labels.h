// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <iosfwd>
#include <string>
#include <vector>

#include "core/types/error.h"
#include "core/types/recording.h"
#include "core/types/snapshot.h"

namespace planewright {

/// Per slice and beam the id of the plane that the return lies on; kNoLabel for no return or no plane.
using Labels = std::vector<std::vector<int>>;
inline constexpr int kNoLabel = -1;
/// In known labels: a return from a surface that is no plane, which counts neither for nor against anyone.
inline constexpr int kIgnoredLabel = -2;

/// The final plane of every beam of a recording: the beams with an echo from the first to the last of each segment of a
/// plane have its id. A slice that the extraction did not see has none.
Labels labelsOf(const Snapshot& snapshot, const Recording& recording);

/// Writes labels: a line per slice, an integer per beam, separated by blanks. Errors: NotWritten.
Result<void> writeLabels(std::ostream& out, const Labels& labels);

/// Reads labels, plain or compressed with gzip. Errors (Unreadable) name file, line and beam: a label that is no whole
/// number from -2, lines of different length, an empty file, more labels than a recording may hold ranges.
Result<Labels> readLabels(std::istream& in, const std::string& fileName);

}  // namespace planewright
