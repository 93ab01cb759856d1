// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <vector>

#include "core/planes/plane_fit.h"
#include "core/planes/segment_table.h"
#include "core/types/step_recorder.h"

namespace planewright {

/// A segment that a plane may be made of, and whether it starts a hypothesis.
struct Candidate {
    SegmentNumber segment = 0;
    bool seed = false;
};

/// A plane found among candidates, and the segments that support it.
struct FoundPlane {
    PlaneFit fit;
    std::vector<SegmentNumber> members;
    std::vector<Test> tests;  ///< why it is available
};

/// A hypothesis that was not available, and why.
struct FailedHypothesis {
    SegmentNumber seed = 0;
    std::vector<Test> tests;
};

/// Finds the plane best supported by the candidates (section 4.3.1 and 4.3.2, Table V lines 3 to 5).
///
/// Every seed makes a hypothesis with the two nearest candidates of other slices, by least squares, Eq. (13); its cost
/// is Eq. (14) over all end points. The cheapest is refined; if it is not available (too few segments, slices or
/// points, too narrow, or E above e_f) the next one is tried that none before has covered. No number is random: all
/// triples of neighbours are few enough.
///
/// An addition: a plane that its own segments contest (segment_run.h) is not available either, and before the next
/// hypothesis the planes of the runs among its support are tried.
std::optional<FoundPlane> findPlane(const std::vector<Candidate>& candidates, const SegmentTable& table,
                                    const PlaneParameters& parameters, std::vector<FailedHypothesis>* failures);

}  // namespace planewright
