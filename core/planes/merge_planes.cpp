// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "core/planes/neighbourhood.h"
#include "core/planes/segment_run.h"
#include "core/planes/split_and_merge.h"

namespace planewright {

namespace {

/// Pairs are told as nearly merged up to this many times the merge distance.
constexpr double kNearFactor = 2.0;

/// Distance of an end point of one plane from the other, and what it may be: the merge distance on top of how far the
/// end point may lie from its own plane, since segments were let in that far.
PairDistance distanceAt(const Eigen::Vector3d& point, const Eigen::Matrix3d& covariance, const GrowingPlane& to,
                        const Parameters& parameters)
{
    const AssignmentParameters& assignment = parameters.assignment;
    const double pointSigma = std::sqrt(to.normal().dot(covariance * to.normal()));
    const double planeSigma = std::sqrt(to.varianceAt(point));
    const double allowed = std::max(assignment.planeDistance, assignment.planeDistanceSigmas * pointSigma);
    return {to.distanceTo(point),
            allowed + std::max(parameters.planes.mergeDistance, parameters.planes.mergeSigmas * planeSigma)};
}

bool worse(const PairDistance& a, const PairDistance& b)
{
    return a.value * b.limit > b.value * a.limit;
}

/// The distance of two boxes around end points, a lower bound of the gap.
double boxDistance(const GrowingPlane& a, const GrowingPlane& b)
{
    double squared = 0.0;
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
        const auto low = static_cast<std::size_t>(2 * axis);
        const double gap = std::max({0.0, a.extremes()[low][axis] - b.extremes()[low + 1][axis],
                                     b.extremes()[low][axis] - a.extremes()[low + 1][axis]});
        squared += gap * gap;
    }
    return std::sqrt(squared);
}

/// True where a segment of one plane faces one of the other; both list their segments in order of step.
bool anyFaceEachOther(const GrowingPlane& a, const GrowingPlane& b, const SegmentTable& table)
{
    std::size_t low = 0;
    for (const SegmentNumber i : a.members()) {
        const int step = table[i].id.step;
        while (low < b.members().size() && table[b.members()[low]].id.step < step - kNeighbourSlices)
            ++low;
        for (std::size_t j = low; j < b.members().size() && table[b.members()[j]].id.step <= step + kNeighbourSlices;
             ++j) {
            if (faceEachOther(table[i], table[b.members()[j]]))
                return true;
        }
    }
    return false;
}

struct Pair {
    PlaneId first = kNoPlane;
    PlaneId second = kNoPlane;
    double distance = 0.0;
    std::vector<Test> tests;
};

bool passes(const Pair& pair)
{
    return std::all_of(pair.tests.begin(), pair.tests.end(), [](const Test& test) { return test.pass(); });
}

/// Compares two planes for merging; none where they are out of the question, unless everything is asked of all.
std::optional<Pair> compare(const GrowingPlane& a, const GrowingPlane& b, const SegmentTable& table,
                            const Parameters& parameters, bool everything = false)
{
    const PlaneParameters& planes = parameters.planes;
    const double alignment = std::abs(a.normal().dot(b.normal()));
    const double angleSigma = std::sqrt(a.normalVariance() + b.normalVariance());
    const double alignmentLimit =
        std::cos(std::clamp(planes.mergeSigmas * angleSigma, planes.mergeAngle, 4.0 * planes.mergeAngle));
    if (alignment <= alignmentLimit && !everything)
        return std::nullopt;

    WeightedSums sums = a.sums();
    sums += b.sums();
    const PlaneFit together = fitPlane(sums, a.normal());
    const double errorA = a.sums().meanError(together.normal, together.distance);
    const double errorB = b.sums().meanError(together.normal, together.distance);
    const double error = std::max(errorA, errorB);
    if (error > kNearFactor * planes.errorLimit && !everything)
        return std::nullopt;
    const PairDistance distance = planePairDistance(a, b, table, parameters);
    Pair pair{a.id(), b.id(), distance.value, {}};
    pair.tests = {{"normal_alignment", alignment, Comparison::Greater, alignmentLimit},
                  {"plane_distance", distance.value, Comparison::Less, distance.limit},
                  {"in_plane_gap", inPlaneGap(a, b, table, planes.mergeGap), Comparison::LessEqual, planes.mergeGap},
                  {"fitting_error", error, Comparison::LessEqual, planes.errorLimit}};
    if (everything || passes(pair)) {
        const auto contestedBy = [&](const GrowingPlane& plane) {
            return contestedShare(plane.members(), together.normal, together.distance, table, planes);
        };
        pair.tests.push_back(
            {"contested", std::max(contestedBy(a), contestedBy(b)), Comparison::LessEqual, planes.maxContested});
    }
    return pair;
}

/// The second plane's segments go to the larger one, which keeps its id.
void merge(const Pair& pair, PlaneMap& map, const Parameters& parameters, StepRecorder& recorder)
{
    GrowingPlane& first = map.plane(pair.first);
    GrowingPlane& second = map.plane(pair.second);
    const bool firstIsLarger = first.members().size() >= second.members().size();
    GrowingPlane& kept = firstIsLarger ? first : second;
    const GrowingPlane& gone = firstIsLarger ? second : first;
    const PlaneId goneId = gone.id();
    for (const SegmentNumber segment : gone.members())
        map.segments.owner(segment) = kept.id();
    kept.absorb(gone, map.segments, parameters.planes, map.step);
    kept.setLineage({Lineage::Kind::Merged, {pair.first, pair.second}});
    ++recorder.counts().merges;
    recorder.decide(DecisionKind::Merge, {PlaneRef{pair.first}, PlaneRef{pair.second}}, pair.tests,
                    {PlaneRef{kept.id()}});
    std::erase_if(map.planes, [goneId](const GrowingPlane& plane) { return plane.id() == goneId; });
}

}  // namespace

PairDistance planePairDistance(const GrowingPlane& a, const GrowingPlane& b, const SegmentTable& table,
                               const Parameters& parameters)
{
    PairDistance worst{-1.0, 1.0};  // below that of any end point, also of those at distance 0
    const auto look = [&](const GrowingPlane& from, const GrowingPlane& to) {
        for (const SegmentNumber number : from.members()) {
            const LineSegment& segment = table[number];
            for (const PairDistance& here : {distanceAt(segment.start, segment.startCovariance, to, parameters),
                                             distanceAt(segment.end, segment.endCovariance, to, parameters)}) {
                if (worse(here, worst))
                    worst = here;
            }
        }
    };
    look(a, b);
    look(b, a);
    return worst;
}

double inPlaneGap(const GrowingPlane& a, const GrowingPlane& b, const SegmentTable& table, double enough)
{
    if (anyFaceEachOther(a, b, table))
        return 0.0;
    double gap = boxDistance(a, b);
    if (gap > enough)
        return gap;
    gap = std::numeric_limits<double>::infinity();
    for (const SegmentNumber i : a.members()) {
        for (const SegmentNumber j : b.members())
            gap = std::min(gap, segmentDistance(table[i], table[j]));
    }
    return gap;
}

Conditions mergeConditions(const GrowingPlane& a, const GrowingPlane& b, const SegmentTable& table,
                           const Parameters& parameters)
{
    const bool inOrder = a.id() < b.id();
    return {"merge", compare(inOrder ? a : b, inOrder ? b : a, table, parameters, true)->tests};
}

void mergePlanes(PlaneMap& map, const Parameters& parameters, StepRecorder& recorder)
{
    std::vector<Pair> pairs;
    const auto addPairsOf = [&](std::size_t i, std::size_t firstOther) {
        for (std::size_t j = firstOther; j < map.planes.size(); ++j) {
            if (i == j)
                continue;
            const auto& a = map.planes[std::min(i, j)];
            const auto& b = map.planes[std::max(i, j)];
            if (map.comparedAlready(a, b))
                continue;
            if (auto pair = compare(a, b, map.segments, parameters))
                pairs.push_back(std::move(*pair));
        }
    };
    for (std::size_t i = 0; i < map.planes.size(); ++i)
        addPairsOf(i, i + 1);

    while (true) {
        auto best = pairs.end();
        for (auto pair = pairs.begin(); pair != pairs.end(); ++pair) {
            if (passes(*pair) && (best == pairs.end() || pair->distance < best->distance))
                best = pair;
        }
        if (best == pairs.end())
            break;
        const Pair merged = std::move(*best);
        merge(merged, map, parameters, recorder);
        std::erase_if(pairs, [&](const Pair& pair) {
            return pair.first == merged.first || pair.first == merged.second || pair.second == merged.first ||
                   pair.second == merged.second;
        });
        const auto kept = std::find_if(map.planes.begin(), map.planes.end(), [&](const GrowingPlane& plane) {
            return plane.id() == merged.first || plane.id() == merged.second;
        });
        addPairsOf(static_cast<std::size_t>(kept - map.planes.begin()), 0);
    }
    for (Pair& pair : pairs)
        recorder.decide(DecisionKind::Near, {PlaneRef{pair.first}, PlaneRef{pair.second}}, std::move(pair.tests));
}

}  // namespace planewright
