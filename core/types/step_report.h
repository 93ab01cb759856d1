// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <string_view>
#include <variant>
#include <vector>

#include "core/types/line_segment.h"
#include "core/types/plane.h"

namespace planewright {

/// The lines of Table I, and the forced last pass.
enum class Phase { Extract, Assign, Cluster, Fit, SplitMerge, Remaining, Finish };
inline constexpr std::size_t kPhases = 7;
inline constexpr std::array<std::string_view, kPhases> kPhaseNames{"extract",     "assign",    "cluster", "fit",
                                                                   "split_merge", "remaining", "finish"};
constexpr std::string_view name(Phase phase)
{
    return kPhaseNames[static_cast<std::size_t>(phase)];
}

/// What was decided about the operands.
enum class DecisionKind {
    Assign,   ///< a segment joined a plane
    Reject,   ///< a piece of a slice was no segment, or a segment joined no plane
    Cluster,  ///< a segment joined a cluster
    Fit,      ///< a cluster gave a plane
    NoFit,    ///< a cluster gave none
    Split,    ///< a plane was taken apart
    Merge,    ///< two planes became one
    Near,     ///< two planes nearly merged
};
inline constexpr std::array<std::string_view, 8> kDecisionKindNames{"assign", "reject", "cluster", "fit",
                                                                    "no_fit", "split",  "merge",   "near"};
constexpr std::string_view name(DecisionKind kind)
{
    return kDecisionKindNames[static_cast<std::size_t>(kind)];
}

/// A plane or a cluster as an operand; segments stand for themselves.
struct PlaneRef {
    PlaneId id;
};
struct ClusterRef {
    ClusterId id;
};
/// Neighbouring echoes of a slice that became no segment, by their beams, both ends included.
struct PieceRef {
    int step = 0;
    int firstBeam = 0;
    int lastBeam = 0;
};
using Operand = std::variant<SegmentId, PlaneRef, ClusterRef, PieceRef>;

/// How a value was compared with its limit.
enum class Comparison { Less, LessEqual, Greater, GreaterEqual };
inline constexpr std::array<std::string_view, 4> kComparisonNames{"<", "<=", ">", ">="};
constexpr std::string_view name(Comparison comparison)
{
    return kComparisonNames[static_cast<std::size_t>(comparison)];
}

/// One comparison: its name, the number, the threshold in force, and whether it held. SI units (m, rad, counts).
struct Test {
    std::string_view name;  ///< a literal: "plane_distance", "fitting_error", …
    double value = 0.0;
    Comparison comparison = Comparison::Less;
    double limit = 0.0;

    bool pass() const
    {
        switch (comparison) {
            case Comparison::Less:
                return value < limit;
            case Comparison::LessEqual:
                return value <= limit;
            case Comparison::Greater:
                return value > limit;
            case Comparison::GreaterEqual:
                return value >= limit;
        }
        return false;
    }
};

/// One decision with the numbers that made it.
struct Decision {
    Phase phase = Phase::Extract;
    DecisionKind kind = DecisionKind::Assign;
    std::vector<Operand> operands;
    std::vector<Test> tests;
    std::vector<Operand> result;
};

/// Totals after a step.
struct StepCounts {
    int returns = 0;    ///< beams of this slice with an echo
    int segments = 0;   ///< line segments of this slice
    int assigned = 0;   ///< of these, assigned to an existing plane at once
    int clustered = 0;  ///< of these, put into a cluster
    int fitted = 0;     ///< segments of the scan so far that belong to a plane
    int unfitted = 0;   ///< segments of the scan so far that belong to none
    int clusters = 0;   ///< clusters that hold a segment
    int planes = 0;
    int splits = 0;          ///< planes split at this step
    int merges = 0;          ///< pairs merged at this step
    double meanError = 0.0;  ///< mean fitting error over the planes
};

/// What one scan step did, how long each phase took, and (where asked for) why.
struct StepReport {
    int step = 0;       ///< −1 for the forced last pass
    double tilt = 0.0;  ///< pitch of the slice [rad]
    StepCounts counts;
    std::array<std::chrono::nanoseconds, kPhases> times{};  ///< by the caller's clock; zero without one
    std::vector<Decision> decisions;                        ///< empty unless explanations are on
};

}  // namespace planewright
