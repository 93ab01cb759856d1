// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <compare>

namespace planewright {

/// Neighbouring beams of the slice of a step, both ends included: a piece of it that became no segment.
struct BeamRun {
    int step = 0;
    int firstBeam = 0;
    int lastBeam = 0;

    friend auto operator<=>(const BeamRun&, const BeamRun&) = default;
};

}  // namespace planewright
