// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include "core/params/parameters.h"
#include "core/types/recording.h"
#include "core/types/snapshot.h"

namespace planewright {

/// Gives echoes of no segment, and those at the border of two planes, to the plane next to them that explains them
/// best.
///
/// `labels[slice][beam]` is the plane that the beam's segment belongs to, or kNoPlane. Looked at are the planes to the
/// left, to the right, and of the same beam one slice before and after; the one with the smallest distance in standard
/// deviations gets the echo, if that is below three, and the label counts for the echoes next to it. With the estimator
/// by end points nothing changes: there a segment is all that counts.
void completeLabels(std::vector<std::vector<PlaneId>>& labels, const Snapshot& snapshot, const Recording& recording,
                    const Parameters& parameters);

}  // namespace planewright
