// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "core/planes/split_and_merge.h"

namespace planewright {

namespace {

/// Slices that lie next to each other for the gap between two planes: one may be missing between them.
constexpr int kNeighbourSlices = 2;

/// Pairs are told as nearly merged up to this many times the merge distance.
constexpr double kNearFactor = 2.0;

double farthestEndPoint(const GrowingPlane& plane, const GrowingPlane& from, const SegmentTable& table)
{
    double farthest = 0.0;
    for (const SegmentNumber number : from.members())
        farthest = std::max({farthest, plane.distanceTo(table[number].start), plane.distanceTo(table[number].end)});
    return farthest;
}

/// A lower bound of Eq. (22) from six end points each.
double leastPairDistance(const GrowingPlane& a, const GrowingPlane& b)
{
    double farthest = 0.0;
    for (const Eigen::Vector3d& point : b.extremes())
        farthest = std::max(farthest, a.distanceTo(point));
    for (const Eigen::Vector3d& point : a.extremes())
        farthest = std::max(farthest, b.distanceTo(point));
    return farthest;
}

/// Smallest distance between two segments in space.
double segmentDistance(const LineSegment& a, const LineSegment& b)
{
    const Eigen::Vector3d alongA = a.end - a.start;
    const Eigen::Vector3d alongB = b.end - b.start;
    const Eigen::Vector3d between = a.start - b.start;
    const double aa = alongA.squaredNorm();
    const double bb = alongB.squaredNorm();
    const double ab = alongA.dot(alongB);
    const double ad = alongA.dot(between);
    const double bd = alongB.dot(between);
    const double denominator = aa * bb - ab * ab;
    const double free = denominator > 1e-12 * aa * bb ? std::clamp((ab * bd - ad * bb) / denominator, 0.0, 1.0) : 0.0;
    // The nearest point of b to that of a, then of a to that of b: exact unless both are clamped, then within a hair.
    const double onB = std::clamp((ab * free + bd) / bb, 0.0, 1.0);
    const double onA = std::clamp((ab * onB - ad) / aa, 0.0, 1.0);
    return (between + onA * alongA - onB * alongB).norm();
}

bool faceEachOther(const LineSegment& a, const LineSegment& b)
{
    return std::abs(a.id.step - b.id.step) <= kNeighbourSlices && a.firstBeam <= b.lastBeam &&
           b.firstBeam <= a.lastBeam;
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

struct Pair {
    PlaneId first = kNoPlane;
    PlaneId second = kNoPlane;
    double distance = 0.0;
    std::vector<Test> tests;
};

/// E of both planes' end points together, by the weights that they have.
double errorTogether(const GrowingPlane& a, const GrowingPlane& b)
{
    WeightedSums sums = a.sums();
    sums += b.sums();
    return fitPlane(sums, a.normal()).error;
}

/// Compares two planes for merging; none where they are out of the question.
std::optional<Pair> compare(const GrowingPlane& a, const GrowingPlane& b, const SegmentTable& table,
                            const PlaneParameters& parameters)
{
    const double alignment = std::abs(a.normal().dot(b.normal()));
    const double alignmentLimit = std::cos(parameters.mergeAngle);
    if (alignment <= alignmentLimit || leastPairDistance(a, b) >= kNearFactor * parameters.mergeDistance)
        return std::nullopt;
    Pair pair{a.id(), b.id(), planePairDistance(a, b, table), {}};
    if (pair.distance >= kNearFactor * parameters.mergeDistance)
        return std::nullopt;
    pair.tests = {
        {"normal_alignment", alignment, Comparison::Greater, alignmentLimit},
        {"plane_distance", pair.distance, Comparison::Less, parameters.mergeDistance},
        {"in_plane_gap", inPlaneGap(a, b, table, parameters.mergeGap), Comparison::LessEqual, parameters.mergeGap},
        {"fitting_error", errorTogether(a, b), Comparison::LessEqual, parameters.errorLimit}};
    return pair;
}

bool passes(const Pair& pair)
{
    return std::all_of(pair.tests.begin(), pair.tests.end(), [](const Test& test) { return test.pass(); });
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

double planePairDistance(const GrowingPlane& a, const GrowingPlane& b, const SegmentTable& table)
{
    return std::max(farthestEndPoint(a, b, table), farthestEndPoint(b, a, table));
}

double inPlaneGap(const GrowingPlane& a, const GrowingPlane& b, const SegmentTable& table, double enough)
{
    double gap = boxDistance(a, b);
    if (gap > enough)
        return gap;
    gap = std::numeric_limits<double>::infinity();
    for (const SegmentNumber i : a.members()) {
        for (const SegmentNumber j : b.members()) {
            if (faceEachOther(table[i], table[j]))
                return 0.0;
            gap = std::min(gap, segmentDistance(table[i], table[j]));
        }
    }
    return gap;
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
            if (auto pair = compare(a, b, map.segments, parameters.planes))
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
