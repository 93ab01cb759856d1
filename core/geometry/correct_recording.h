// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include "core/params/parameters.h"
#include "core/types/recording.h"

namespace planewright {

/// Corrects a recording by what a calibration has found (`sensor.*`), in place: from then on it is as if the scanner
/// had been right, for every method and every output. A correction that is zero leaves every number as it was.
///
/// A return becomes longer by the offset, and the limits of returns move with it, so that the same beams are returns;
/// one that would end at or behind the laser is none. The pitch of a beam grows by the zero, and where the head nods on
/// by the delay and by its share of the sweep's turn; the end pitch is set where there is such a turn.
void correctRecording(Recording& recording, const SensorParameters& sensor);

/// How far the head nods from one step to the next at each slice [rad]: half of the way from the slice before to the
/// slice after by the measured pitches, one-sided at both ends. Missing steps count; a slice alone does not nod.
std::vector<double> noddingRates(const std::vector<ScanSlice>& slices);

}  // namespace planewright
