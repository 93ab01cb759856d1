// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <string_view>
#include <vector>

#include "core/types/step_report.h"

namespace planewright {

/// A way in which two planes become one or a segment joins a plane: all its conditions, in the order in which they are
/// asked. It is taken when all hold and its turn comes.
struct Conditions {
    std::string_view name;  ///< a literal: "merge", "absorb", "assign", "reassign"; "join_facing", "join_known", "move"
    std::vector<Test> tests;

    bool pass() const
    {
        return std::all_of(tests.begin(), tests.end(), [](const Test& test) { return test.pass(); });
    }
};

/// Why two planes are not one, or a segment is not in a plane, as things are after a step.
///
/// The numbers are those of the code that decides. When the question is due, and whether its answer still holds from
/// the last time, is not among the conditions.
struct WhyNot {
    std::vector<Operand> operands;  ///< as they were asked about
    bool together = false;          ///< the segment is in the plane
    std::vector<Conditions> ways;
};

}  // namespace planewright
