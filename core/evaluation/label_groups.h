// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/evaluation/label_overlap.h"
#include "core/evaluation/plane_errors.h"

namespace planewright {

/// Ids of coplanar planes, which count as one, in rising order.
using PlaneGroup = std::vector<int>;

/// The regions of B in groups of coplanar planes, and what each region of A shares with each group.
struct LabelGroups {
    struct Group {
        PlaneGroup ids;
        std::int64_t returns = 0;
        bool counts = false;  ///< has the returns that a group must have to be counted
    };
    std::vector<Group> groups;                 ///< in order of their lowest id
    std::vector<std::size_t> groupOf;          ///< group of each region of B
    std::vector<LabelOverlap::Common> shared;  ///< as LabelOverlap::common, but b is a group
};

/// Puts the regions of B whose planes are coplanar (areCoplanar) into groups; `planesB` are those of overlap.regionsB,
/// in their order.
LabelGroups groupRegions(const LabelOverlap& overlap, std::span<const ComparedPlane> planesB, std::int64_t minReturns);

}  // namespace planewright
