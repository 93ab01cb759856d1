// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include "core/types/snapshot.h"

namespace planewright {

/// Who holds each line segment: entry [slice][index] for the slices of the snapshot's segment log in their order.
struct SegmentOwners {
    std::vector<std::vector<PlaneId>> planes;      ///< kNoPlane for none
    std::vector<std::vector<ClusterId>> clusters;  ///< kNoCluster for none
};

SegmentOwners segmentOwners(const Snapshot& snapshot);

}  // namespace planewright
