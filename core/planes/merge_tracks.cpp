// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/planes/track_publishing.h"
#include "core/planes/track_stages.h"

namespace planewright {

namespace {

/// Planes are compared anew once one of them has so many times the points it had.
constexpr double kGrown = 1.25;
/// |n·n| of planes that may be one at least.
constexpr double kAlignment = 0.9;
/// By how much worse one plane may explain the segments of two that scatter than each of these explains its own.
constexpr double kWorse = 1.6;
/// Pairs are looked at more closely, and told as nearly merged, up to this many times the gate.
constexpr double kNearGates = 4.0;

bool sideBySide(const PlaneTrack& a, const PlaneTrack& b, const TrackMap& map)
{
    for (const SegmentNumber number : a.members) {
        const int place = map.segment(number).slice;
        for (int other = place - map.lookback(place); other <= place + map.lookahead(place); ++other) {
            bool found = false;
            map.visitOverlaps(other, map.beams(number), kSideMargin,
                              [&](SegmentNumber s) { found = found || map.segment(s).owner == b.id; });
            if (found)
                return true;
        }
    }
    return false;
}

bool hasGrown(const PlaneTrack& plane)
{
    return static_cast<double>(plane.points) > kGrown * static_cast<double>(plane.comparedAt);
}

std::vector<SegmentNumber> membersOf(const PlaneTrack& a, const PlaneTrack& b)
{
    std::vector<SegmentNumber> all(a.members.size() + b.members.size());
    std::merge(a.members.begin(), a.members.end(), b.members.begin(), b.members.end(), all.begin());
    return all;
}

/// By how much worse one plane explains the segments of two than each of these explains its own. Covariances of planes
/// that scatter tell less: what surfaces and scanners are off is alike from slice to slice, and not by chance.
double worseTogether(const PlaneTrack& a, const PlaneTrack& b, TrackMap& map, const Parameters& parameters)
{
    PlaneTrack both = a.points >= b.points ? a : b;
    both.members = membersOf(a, b);
    if (!map.rebuild(both, parameters))
        return kWorse;
    const auto weight = [](const PlaneTrack& plane) { return static_cast<double>(plane.members.size()); };
    return meanErrorOf(both) * weight(both) / (scatterOf(a) * weight(a) + scatterOf(b) * weight(b));
}

Test alignmentTest(const PlaneTrack& a, const PlaneTrack& b)
{
    return {"normal_alignment", std::abs(a.estimate.normal().dot(b.estimate.normal())), Comparison::Greater,
            kAlignment};
}

/// Whether two planes are near enough for a closer look: by their covariances, or, where these tell too little because
/// segments scatter, by covariances that grow by as much.
struct Nearness {
    Test near;
    std::optional<Test> scattered;

    bool pass() const { return near.pass() && (!scattered || scattered->pass()); }
};

Nearness nearnessOf(const PlaneTrack& a, const PlaneTrack& b, const Parameters& parameters)
{
    const double gate = parameters.likelihood.mergeGate;
    const double floor = 0.5 * parameters.flatnessFloor();
    const double chi = a.estimate.mergeChi(b.estimate, floor, 1.0);
    const double scatter = std::max(scatterOf(a), scatterOf(b));
    Nearness nearness{{"near_chi2", chi, Comparison::Less, kNearGates * gate * scatter}, std::nullopt};
    if (chi >= gate && scatter > 1.0)
        nearness.scattered = {"scattered_chi2", a.estimate.mergeChi(b.estimate, floor, 1.0, scatterOf(a), scatterOf(b)),
                              Comparison::Less, kNearGates * gate};
    return nearness;
}

/// Whether two planes are beside each other, or known so well that it does not matter.
Test adjacencyTest(const PlaneTrack& a, const PlaneTrack& b, const TrackMap& map, const Parameters& parameters)
{
    const double known = parameters.likelihood.mergeAngle * parameters.likelihood.mergeAngle;
    const bool sharp = a.estimate.normalVariance() < known && b.estimate.normalVariance() < known;
    return {"adjacent", sharp || sideBySide(a, b, map) ? 1.0 : 0.0, Comparison::GreaterEqual, 1.0};
}

/// Whether they are one: by their covariances, or, where segments scatter, by how well one explains those of both.
Test onenessTest(const PlaneTrack& a, const PlaneTrack& b, const Nearness& nearness, bool isAdjacent, TrackMap& map,
                 const Parameters& parameters)
{
    if (isAdjacent && nearness.scattered)
        return {"worse_together", worseTogether(a, b, map, parameters), Comparison::Less, kWorse};
    return {"merge_chi2", nearness.near.value, Comparison::Less, parameters.likelihood.mergeGate};
}

/// Whether two planes are one. What was compared is told where they nearly are.
bool areOne(const PlaneTrack& a, const PlaneTrack& b, TrackMap& map, const Parameters& parameters,
            StepRecorder& recorder)
{
    const Test alignment = alignmentTest(a, b);
    if (!alignment.pass())
        return false;
    const Nearness nearness = nearnessOf(a, b, parameters);
    if (!nearness.pass())
        return false;
    const Test adjacent = adjacencyTest(a, b, map, parameters);
    const Test oneness = onenessTest(a, b, nearness, adjacent.pass(), map, parameters);
    const bool one = adjacent.pass() && oneness.pass();
    if (recorder.explains())
        recorder.decide(
            one ? DecisionKind::Merge : DecisionKind::Near, {PlaneRef{a.id}, PlaneRef{b.id}},
            {alignment, adjacent, oneness},
            one ? std::vector<Operand>{PlaneRef{a.points >= b.points ? a.id : b.id}} : std::vector<Operand>{});
    return one;
}

/// Gives a plane all segments of another, which is to disappear.
void takeOver(PlaneTrack& kept, const PlaneTrack& gone, TrackMap& map, const Parameters& parameters, int step)
{
    for (const SegmentNumber number : gone.members)
        map.segment(number).owner = kept.id;
    kept.members = membersOf(kept, gone);
    kept.points += gone.points;
    kept.lastSlice = std::max(kept.lastSlice, gone.lastSlice);
    kept.slices = 0;
    int last = -1;
    for (const SegmentNumber number : kept.members) {
        kept.slices += map.segment(number).slice != last ? 1 : 0;
        last = map.segment(number).slice;
    }
    kept.lineage = {Lineage::Kind::Merged, {std::min(kept.id, gone.id), std::max(kept.id, gone.id)}};
    kept.comparedAt = 0;
    map.rebuild(kept, parameters);
    map.touch(kept, step);
}

/// Compares the planes that have grown with all others; true where some became one.
bool mergeGrown(TrackMap& map, const Parameters& parameters, StepRecorder& recorder)
{
    const int step = map.slice(map.slices() - 1).step;
    std::vector<PlaneTrack>& planes = map.planes();
    std::vector<PlaneId> merged;
    for (std::size_t i = 0; i < planes.size(); ++i) {
        for (std::size_t j = i + 1; j < planes.size();) {
            PlaneTrack& a = planes[i];
            PlaneTrack& b = planes[j];
            if ((!hasGrown(a) && !hasGrown(b)) || !areOne(a, b, map, parameters, recorder)) {
                ++j;
                continue;
            }
            const bool keepsFirst = a.points >= b.points;
            takeOver(keepsFirst ? a : b, keepsFirst ? b : a, map, parameters, step);
            merged.push_back(keepsFirst ? a.id : b.id);
            planes.erase(planes.begin() + static_cast<std::ptrdiff_t>(keepsFirst ? j : i));
            ++recorder.counts().merges;
            // Whichever stayed is compared with all that follow once more.
            j = i + 1;
        }
    }
    for (PlaneTrack& plane : planes) {
        if (hasGrown(plane) && std::find(merged.begin(), merged.end(), plane.id) == merged.end())
            plane.comparedAt = plane.points;
    }
    return !merged.empty();
}

}  // namespace

double scatterOf(const PlaneTrack& plane)
{
    return std::max(1.0, meanErrorOf(plane));
}

Conditions mergeConditions(const PlaneTrack& a, const PlaneTrack& b, TrackMap& map, const Parameters& parameters)
{
    const bool inOrder = a.id < b.id;
    const PlaneTrack& first = inOrder ? a : b;
    const PlaneTrack& second = inOrder ? b : a;
    const Nearness nearness = nearnessOf(first, second, parameters);
    const Test adjacent = adjacencyTest(first, second, map, parameters);
    Conditions way{"merge", {alignmentTest(first, second), nearness.near}};
    if (nearness.scattered)
        way.tests.push_back(*nearness.scattered);
    way.tests.push_back(adjacent);
    way.tests.push_back(onenessTest(first, second, nearness, adjacent.pass(), map, parameters));
    return way;
}

void mergeTracks(TrackMap& map, const Parameters& parameters, StepRecorder& recorder)
{
    const int step = map.slice(map.slices() - 1).step;
    for (PlaneTrack& plane : map.planes()) {
        if (plane.slicesUnsolved > 0 && plane.estimate.solve()) {
            plane.slicesUnsolved = 0;
            map.touch(plane, step);
        }
    }
    // What became one may be known well enough to be one with a plane that was compared before.
    while (mergeGrown(map, parameters, recorder)) {
    }
}

}  // namespace planewright
