// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/models/compared_phase.h"

#include <algorithm>

namespace planewright {

ComparedPhase comparedPhase(const PhasedStep& a, std::size_t number, const PhasedStep& b)
{
    const PhaseState& wanted = a.phases[number];
    if (wanted.phase != Phase::Finish) {
        ComparedPhase found;
        for (const PhaseState& state : b.phases) {
            if (state.phase <= wanted.phase)
                found = {&state, state.phase == wanted.phase};
        }
        return found;
    }
    const auto isSame = [&](const PhaseState& state) { return state.pass == wanted.pass; };
    auto before = std::count_if(a.phases.begin(), a.phases.begin() + static_cast<std::ptrdiff_t>(number), isSame);
    for (const PhaseState& state : b.phases) {
        if (isSame(state) && before-- == 0)
            return {&state, true};
    }
    return {};
}

}  // namespace planewright
