// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string_view>
#include <variant>
#include <vector>

#include "core/types/step_recorder.h"

namespace planewright {

/// A recorder with explanations and the report that it writes.
struct Recorded {
    StepReport report;
    StepClock clock;
    StepRecorder recorder{report, clock, true};

    std::vector<Decision> decisions(DecisionKind kind) const
    {
        std::vector<Decision> all;
        std::copy_if(report.decisions.begin(), report.decisions.end(), std::back_inserter(all),
                     [kind](const Decision& decision) { return decision.kind == kind; });
        return all;
    }
};

inline bool allPass(const std::vector<Test>& tests)
{
    return std::all_of(tests.begin(), tests.end(), [](const Test& test) { return test.pass(); });
}

/// The test of a name; one that is not there has a limit that nothing passes.
inline Test testOf(const std::vector<Test>& tests, std::string_view name)
{
    const auto found = std::find_if(tests.begin(), tests.end(), [name](const Test& test) { return test.name == name; });
    return found == tests.end() ? Test{"missing", std::nan(""), Comparison::Less, std::nan("")} : *found;
}

/// The names of the tests that failed.
inline std::vector<std::string_view> failed(const std::vector<Test>& tests)
{
    std::vector<std::string_view> names;
    for (const Test& test : tests) {
        if (!test.pass())
            names.push_back(test.name);
    }
    return names;
}

inline SegmentId segmentOf(const Operand& operand)
{
    const auto* id = std::get_if<SegmentId>(&operand);
    return id == nullptr ? SegmentId{-1, -1} : *id;
}
/// The steps of the segments that a decision is about.
inline std::vector<int> stepsOf(const Decision& decision)
{
    std::vector<int> steps;
    for (const Operand& operand : decision.operands)
        steps.push_back(segmentOf(operand).step);
    return steps;
}

inline PlaneId planeOf(const Operand& operand)
{
    const auto* ref = std::get_if<PlaneRef>(&operand);
    return ref == nullptr ? kNoPlane : ref->id;
}
inline ClusterId clusterOf(const Operand& operand)
{
    const auto* ref = std::get_if<ClusterRef>(&operand);
    return ref == nullptr ? kNoCluster : ref->id;
}
inline PieceRef pieceOf(const Operand& operand)
{
    const auto* piece = std::get_if<PieceRef>(&operand);
    return piece == nullptr ? PieceRef{-1, -1, -1} : *piece;
}

}  // namespace planewright
