// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/types/error.h"

namespace planewright {

/// A label per beam, a row per slice: the plane's id, or a negative number for none.
using LabelGrid = std::vector<std::vector<int>>;

/// Label of a known scene for a return from a surface that is no plane: counts neither for nor against anyone.
inline constexpr int kNotAPlane = -2;

/// The regions of two labellings A and B of one scan, and the returns they have in common.
struct LabelOverlap {
    /// A region of A and one of B that share returns; places in regionsA and regionsB.
    struct Common {
        std::size_t a = 0;
        std::size_t b = 0;
        std::int64_t returns = 0;
    };
    /// The beams of one label.
    struct Region {
        int id = 0;
        std::int64_t returns = 0;   ///< without those that B labels kNotAPlane
        std::int64_t notPlane = 0;  ///< those (always 0 in B)
    };
    std::vector<Region> regionsA;  ///< in order of id; negative labels make no region
    std::vector<Region> regionsB;  ///< in order of id; negative labels make no region
    std::vector<Common> common;    ///< in order of a, then b
};

/// Counts the returns of every pair of labels in one pass. Ids may be any int. Errors (Unreadable): the grids differ in
/// rows or in the length of a row; the message names the first line.
Result<LabelOverlap> overlapOf(const LabelGrid& a, const LabelGrid& b);

}  // namespace planewright
