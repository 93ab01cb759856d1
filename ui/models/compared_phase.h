// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>

#include "core/pipeline/plane_extractor.h"

namespace planewright {

/// What another extraction of the same slices has beside a phase of a step.
struct ComparedPhase {
    const PhaseState* state = nullptr;  ///< null: nothing but the whole step
    bool isSame = false;                ///< after the same phase, or the same pass of the last one
};

/// The state of `b` beside phase `number` of `a`, both at one step: after the same phase, or, where that is not due
/// with the parameters of `b`, after the last one before it. Of the forced last pass after the same pass, which may
/// come several times; another method has others, and only its end can be held against them.
ComparedPhase comparedPhase(const PhasedStep& a, std::size_t number, const PhasedStep& b);

}  // namespace planewright
