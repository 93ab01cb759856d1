// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <iosfwd>
#include <span>

#include "core/formats/plane_result.h"
#include "core/types/error.h"

namespace planewright {

/// Writes the outlines as triangles, binary little-endian PLY: vertices `double x y z, int plane_id`, faces `list uchar
/// int vertex_indices, uchar red green blue, int plane_id`, wound counter-clockwise seen from +n. Metres. Colours go by
/// id. A plane without outline gives no face. Errors: NotWritten.
Result<void> writePlanesPly(std::ostream& out, std::span<const PlaneResult> planes);

/// Writes the same triangles as OBJ, one group `plane_ID` a plane. Errors: NotWritten.
Result<void> writePlanesObj(std::ostream& out, std::span<const PlaneResult> planes);

}  // namespace planewright
