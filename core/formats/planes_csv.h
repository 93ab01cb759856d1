// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <iosfwd>
#include <span>
#include <string>
#include <vector>

#include "core/formats/plane_record.h"
#include "core/formats/plane_result.h"
#include "core/types/error.h"

namespace planewright {

/// Writes planes as CSV, `planewright-planes 1`: one row a plane, what is unknown is left empty;
/// planes of a map have a last column `stops`. Errors: NotWritten.
Result<void> writePlanesCsv(std::ostream& out, std::span<const PlaneResult> planes);

/// Reads the planes of a planes CSV, plain or compressed with gzip.
///
/// Columns go by their names: id, nx, ny, nz and d must be there, points, name and class may be, others are passed
/// over. A `'` before `= + - @` at the beginning of a text is taken off, as writePlanesCsv puts it there. Errors
/// (Unreadable) name file, line and column: another format, a missing column, a cell that is no number, a normal not of
/// length 1 (within 1e-3), an id that is negative or occurs twice.
Result<std::vector<PlaneRecord>> readPlanesCsv(std::istream& in, const std::string& fileName);

}  // namespace planewright
