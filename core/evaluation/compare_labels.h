// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/evaluation/label_groups.h"
#include "core/evaluation/label_overlap.h"
#include "core/evaluation/plane_errors.h"
#include "core/types/error.h"

namespace planewright {

/// What counts as a match of regions, and as worth matching.
struct LabelMatchSettings {
    double overlap = 0.5;         ///< a match shares at least this part of both regions, 0 to 1
    std::int64_t minReturns = 0;  ///< groups of B with fewer returns count neither for nor against anyone
};

/// A region of A and the group of B that it is.
struct RegionMatch {
    int a = 0;
    PlaneGroup b;
    std::int64_t common = 0;  ///< returns in both
};

/// A group of B that A has in several pieces.
struct OverSegmentation {
    PlaneGroup b;
    std::vector<int> a;
};

/// A region of A that spans several groups of B.
struct UnderSegmentation {
    int a = 0;
    std::vector<PlaneGroup> b;
};

/// Comparison of two segmentations of a scan after Hoover et al. (1996): every counted group of B and region of A is in
/// exactly one place of correct, over-segmented, under-segmented and missed (B) or noise (A).
struct LabelComparison {
    std::size_t regions = 0;  ///< counted regions of A: all but the ignored
    std::size_t groups = 0;   ///< counted groups of B
    std::vector<RegionMatch> correct;
    std::vector<OverSegmentation> overSegmented;
    std::vector<UnderSegmentation> underSegmented;
    std::vector<PlaneGroup> missed;
    std::vector<int> noise;
    std::vector<int> ignored;  ///< regions of A mostly on what does not count
    double recall = 0.0;       ///< correct / groups; 1 where there is no group
    double precision = 0.0;    ///< correct / regions; 1 where there is no region
    double f1 = 0.0;           ///< harmonic mean of both; 0 where both are 0
    PlaneErrors errors;        ///< of the correct regions, against the plane of the group they share most returns with
};

/// Compares labelling A with labelling B, the truth or the other run.
///
/// Coplanar planes of B (areCoplanar) form one group. A region and a group match when their common returns are at least
/// `overlap` of both; where several could, the largest mean share wins and each is used once. Over-segmented: two or
/// more unmatched regions of A, each at least `overlap` inside the group, cover at least `overlap` of it;
/// under-segmented: the mirror image. What is in one set is not looked for in the next. Returns that B labels
/// kNotAPlane are left out of every size. A region that is in no set and lies to at least `overlap` on such returns or
/// on groups below `minReturns` is ignored, not noise. Planes without any label take no part.
///
/// Errors: Unreadable where the grids differ in shape or a label has no plane; Usage above kMaxComparedPlanes planes.
Result<LabelComparison> compareLabels(const LabelGrid& labelsA, const LabelGrid& labelsB,
                                      std::span<const ComparedPlane> planesA, std::span<const ComparedPlane> planesB,
                                      const LabelMatchSettings& settings);

}  // namespace planewright
