// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <iosfwd>

#include "core/formats/labels.h"
#include "core/types/error.h"
#include "core/types/recording.h"

namespace planewright {

/// Writes every return as a point in the sensor's frame, Eq. (6) [m], as binary little-endian PLY: `float x y z, int
/// plane_id, int step`; plane_id is -1 on no plane. Floats suffice: ranges are whole millimetres, and a float holds 30
/// m to 2 µm. The labels are labelsOf this recording. Errors: NotWritten.
Result<void> writePointsPly(std::ostream& out, const Recording& recording, const Labels& labels);

/// Writes the same as PCD v0.7, binary: `x y z` as floats, `label step` as signed integers. Errors: NotWritten.
Result<void> writePointsPcd(std::ostream& out, const Recording& recording, const Labels& labels);

}  // namespace planewright
