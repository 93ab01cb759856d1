// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "core/pipeline/plane_lives.h"
#include "tests/core/pipeline/drawn_step.h"

namespace planewright {

/// Plane 0 is made of cluster 4, then 1 of cluster 6; 0 is split into 0 and 2; 1 goes into 2; plane 3 has nothing to do
/// with them; the last pass gives 0 up. The newest slice is of step 20.
inline PlaneLives drawnLives()
{
    const auto fitted = [](PlaneId plane, ClusterId cluster) {
        return Decision{Phase::Fit, DecisionKind::Fit, {ClusterRef{cluster}}, {}, {PlaneRef{plane}}};
    };
    PlaneLives lives;
    lives.add(drawnStep(4, {fitted(0, 4)}, {{0, 5}}));
    lives.add(drawnStep(5, {fitted(3, 5)}, {{0, 8}, {3, 4}}));
    lives.add(drawnStep(6, {fitted(1, 6)}, {{0, 8}, {1, 3}, {3, 4}}));
    lives.add(drawnStep(7, {{Phase::SplitMerge, DecisionKind::Split, {PlaneRef{0}}, {}, {PlaneRef{0}, PlaneRef{2}}}},
                        {{0, 4}, {1, 3}, {2, 4}, {3, 4}}));
    lives.add(drawnStep(14, {{Phase::SplitMerge, DecisionKind::Merge, {PlaneRef{1}, PlaneRef{2}}, {}, {PlaneRef{2}}}},
                        {{0, 4}, {2, 7}, {3, 4}}));
    lives.add(drawnStep(20, {}, {{0, 4}, {2, 7}, {3, 4}}));
    lives.add(drawnStep(-1, {{Phase::Finish, DecisionKind::NoFit, {PlaneRef{0}}, {}, {}}}, {{2, 7}, {3, 4}}));
    return lives;
}

}  // namespace planewright
