// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "core/types/recording.h"

namespace planewright {

/// Degrees that read back to these radians, bit for bit where there is such a number: the one that people would write,
/// or the nearest to it.
double degreesReadingBackTo(double radians);

/// A range [m] in whole millimetres, half up, as recordings hold it; 0 for one that is negative or no number.
double recordedMillimetres(double range);

/// A slice as a recording gives it back: ranges in whole millimetres, angles from degrees. An extraction that is given
/// these while the scan runs makes the same planes, bit for bit, as one of the recording.
ScanSlice asRecorded(ScanSlice slice);

/// The same for what is said once about a scan.
ScanDescription asRecorded(ScanDescription description);

}  // namespace planewright
