// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <iosfwd>

#include "core/types/error.h"
#include "core/types/snapshot.h"

namespace planewright {

/// Writes every line segment as CSV, one row each in order of step and index, with the cluster and the plane that hold
/// it (-1 = none). Metres. Errors: NotWritten.
Result<void> writeSegmentsCsv(std::ostream& out, const Snapshot& snapshot);

/// Writes every line segment as binary little-endian PLY: two vertices `double x y z` and one edge `int vertex1, int
/// vertex2, int plane_id` each (-1 = none). Metres. Errors: NotWritten.
Result<void> writeSegmentsPly(std::ostream& out, const Snapshot& snapshot);

}  // namespace planewright
