// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <iosfwd>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/formats/plane_record.h"
#include "core/formats/plane_result.h"
#include "core/params/parameters.h"
#include "core/types/error.h"

namespace planewright {

/// Writes planes as JSON, `planewright-planes 1`, a plane a line: the CSV's names as keys, null where it is empty
/// there; `covariance` of (tangent angle 1, tangent angle 2, d) with its `tangents`, both null if unknown; and for
/// `polygon_wkt` a `polygon`: the closed rings of all parts, outer rings counter-clockwise seen from +n, each followed
/// by its holes, clockwise. `program` is the program's name and version. Errors: NotWritten.
Result<void> writePlanesJson(std::ostream& out, std::span<const PlaneResult> planes, const Parameters& parameters,
                             std::string_view program);

/// Reads the planes of a planes JSON: of each plane id, nx, ny, nz and d must be there, points, name and class may be.
/// Errors (Unreadable) name file and place; limits as parseStrictJson.
Result<std::vector<PlaneRecord>> readPlanesJson(std::istream& in, const std::string& fileName);

/// Reads the planes of a planes JSON with all that a map needs of them: covariance, tangents and outline, where the
/// file has them. Errors (Unreadable) as above, and for a covariance that is not symmetric, tangents that do not lie
/// in the plane, and rings that are not closed or leave it by more than a centimetre.
Result<std::vector<PlaneResult>> readPlaneResultsJson(std::istream& in, const std::string& fileName);

}  // namespace planewright
