// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "core/types/snapshot.h"

namespace planewright {

/// A step drawn by hand: what was decided, and how many segments each plane has after it.
inline Snapshot drawnStep(int step, std::vector<Decision> decisions, const std::vector<std::pair<PlaneId, int>>& planes)
{
    Snapshot snapshot;
    snapshot.report.step = step;
    snapshot.report.decisions = std::move(decisions);
    for (const auto& [id, size] : planes) {
        Plane plane;
        plane.id = id;
        for (int i = 0; i < size; ++i)
            plane.segments.push_back({i, id});
        snapshot.planes.push_back(std::make_shared<const Plane>(plane));
    }
    return snapshot;
}

}  // namespace planewright
