// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include "core/params/parameters.h"
#include "core/types/recording.h"

namespace planewright {

/// Corrects a whole recording as SliceCorrector does it slice by slice, in place, for every method and every output.
void correctRecording(Recording& recording, const SensorParameters& sensor);

/// How far the head nods from one step to the next at each slice [rad], as SliceCorrector has it.
std::vector<double> noddingRates(const std::vector<ScanSlice>& slices);

}  // namespace planewright
