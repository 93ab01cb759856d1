// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <Eigen/Geometry>

#include "core/planes/fit_segments.h"
#include "core/planes/grow_track.h"
#include "core/planes/parallel_planes.h"
#include "core/planes/track_publishing.h"
#include "core/planes/track_stages.h"
#include "core/types/angle.h"

namespace planewright {

namespace {

/// Tilts between the slices of a triple that are tried one after another [rad]: a fine tilt step gives neighbours too
/// close to tell a plane's direction.
constexpr std::array kTiltGaps{0.0, degrees(0.5), degrees(1.0), degrees(2.0), degrees(4.0), degrees(8.0)};
/// The last of them but for surfaces so near that their slices are no farther apart than ranges are off together.
constexpr double kWidestTiltGap = degrees(1.0);
/// The smallest tilt between them, in standard deviations of the pitch: nearer ones only tell its noise.
constexpr double kTiltGapSigmas = 2.0;
/// Standard deviations that ranges may be off together.
constexpr double kSystematicSigmas = 2.0;
/// Slices looked back over for them at most: a head that rests gives any number.
constexpr int kMostSlicesBack = 64;
/// Segments whose centroids are farther than this from the plane of the two others are no triple [m].
constexpr double kRoughlyCoplanar = 0.08;
/// By how many standard deviations of its normal a plane must be met by the rays.
constexpr double kSureSigmas = 2.0;
/// Planes of more slices do not turn much any more.
constexpr int kTurningSlices = 20;
/// Points that a pair of segments must have, or fewer where they fill this angle [rad].
constexpr double kPairPoints = 40.0;
constexpr double kPairAngle = degrees(10.0);

struct Hypothesis {
    std::array<SegmentNumber, 3> segments{};
    int support = 0;  ///< points of the smallest of the three
    double chi = 0.0;
    double normalVariance = 0.0;
    PlaneEstimate estimate;
};

/// True where the middle one of three centroids is roughly where the plane through the others says.
bool roughlyCoplanar(SegmentNumber a, SegmentNumber b, SegmentNumber c, const TrackMap& map)
{
    const Eigen::Vector3d from = map.centroid(a);
    Eigen::Vector3d normal = directionOf(a, map).cross(map.centroid(c) - from);
    const double length = normal.norm();
    return length > 0.0 && std::abs(normal.dot(map.centroid(b) - from)) < kRoughlyCoplanar * length;
}

/// Calls `visit` for each segment of a slice that belongs to no plane and overlaps another.
template <class Visit>
void visitFree(int place, SegmentNumber facing, const TrackMap& map, Visit visit)
{
    if (place < 0 || place >= map.slices())
        return;
    map.visitOverlaps(place, map.beams(facing), kOverlapMargin, [&](SegmentNumber number) {
        if (map.segment(number).owner == kNoPlane)
            visit(number);
    });
}

/// The nearest slice before one that differs in tilt by so much; −1 where there is none.
int sliceBefore(int place, double tiltGap, const TrackMap& map)
{
    const double tilt = map.slice(place).frame.tilt;
    for (int before = place - 1; before >= std::max(0, place - kMostSlicesBack); --before) {
        if (std::abs(map.slice(before).frame.tilt - tilt) >= tiltGap)
            return before;
    }
    return -1;
}

/// True where a plane is sure to be met by the rays to a segment: a slice's own plane fits all of it, and is none.
bool surelyMet(SegmentNumber number, const PlaneEstimate& estimate, const TrackMap& map, const Parameters& parameters)
{
    const double least = parameters.planes.minIncidence + kSureSigmas * std::sqrt(estimate.normalVariance());
    return map.incidence(number, estimate) >= std::sin(std::min(least, degrees(90.0)));
}

/// What ranges that are off together, each slice on its own, do to the direction of a plane across slices [rad²]:
/// slices too near each other tell nothing of it.
double systematicVariance(SegmentNumber oldest, SegmentNumber newest, const PlaneEstimate& estimate,
                          const TrackMap& map, double systematic)
{
    const double lever = (map.centroid(newest) - map.centroid(oldest)).cross(directionOf(newest, map)).norm();
    const double off = kSystematicSigmas * systematic * map.incidence(newest, estimate);
    return 2.0 * off * off / (lever * lever);
}

/// The widest tilt between the slices of a triple: there, ranges that are off together move the slices by a quarter of
/// what is known of a plane's direction at least.
double widestTiltGap(SegmentNumber newest, const TrackMap& map, const Parameters& parameters)
{
    const SegmentStatistics& s = map.segment(newest).statistics;
    const double off = kSystematicSigmas * parameters.noise.systematic;
    return std::max(kWidestTiltGap, 4.0 * off / (parameters.likelihood.seedAngle * std::hypot(s.u, s.v)));
}

/// Hypotheses of three segments of which the last is `newest`; of the smallest gap that gives any.
void hypothesesOf(SegmentNumber newest, const TrackMap& map, const Parameters& parameters,
                  std::vector<Hypothesis>& hypotheses)
{
    const int place = map.segment(newest).slice;
    const double angle = parameters.likelihood.seedAngle;
    const double widest = widestTiltGap(newest, map, parameters);
    std::pair tried{-1, -1};
    for (const double tiltGap : kTiltGaps) {
        if (tiltGap > widest)
            return;
        const double gap = std::max(tiltGap, kTiltGapSigmas * parameters.noise.pitch);
        const int middlePlace = sliceBefore(place, gap, map);
        const int oldestPlace = middlePlace < 0 ? -1 : sliceBefore(middlePlace, gap, map);
        if (oldestPlace < 0)
            return;
        if (std::exchange(tried, {middlePlace, oldestPlace}) == std::pair{middlePlace, oldestPlace})
            continue;
        const std::size_t before = hypotheses.size();
        visitFree(middlePlace, newest, map, [&](SegmentNumber middle) {
            visitFree(oldestPlace, middle, map, [&](SegmentNumber oldest) {
                if (!roughlyCoplanar(oldest, middle, newest, map))
                    return;
                Hypothesis hypothesis;
                hypothesis.segments = {oldest, middle, newest};
                if (!fitSegments(hypothesis.segments, map, parameters, parameters.noise.systematic,
                                 hypothesis.estimate))
                    return;
                hypothesis.chi = hypothesis.estimate.chi();
                hypothesis.normalVariance = hypothesis.estimate.normalVariance();
                hypothesis.normalVariance +=
                    systematicVariance(oldest, newest, hypothesis.estimate, map, parameters.noise.systematic);
                if (hypothesis.chi >= parameters.likelihood.seedGate || hypothesis.normalVariance >= angle * angle ||
                    !surelyMet(newest, hypothesis.estimate, map, parameters))
                    return;
                hypothesis.support =
                    std::min({map.segment(oldest).statistics.points, map.segment(middle).statistics.points,
                              map.segment(newest).statistics.points});
                hypotheses.push_back(hypothesis);
            });
        });
        if (hypotheses.size() > before)
            return;
    }
}

/// Two facing segments of neighbouring slices. Any two parallel ones are on a plane, so that all that speaks for one
/// pair rather than another is whether rooms have such planes: χ² (2 degrees of freedom) of its normal against that of
/// the nearest known plane.
struct PairHypothesis {
    std::array<SegmentNumber, 2> segments{};
    double chi = 0.0;
    double parallelChi = kNoParallel;
    PlaneEstimate estimate;
};

void pairsOf(SegmentNumber number, const TrackMap& map, const Parameters& parameters,
             std::vector<PairHypothesis>& hypotheses)
{
    const BeamSpan& own = map.beams(number);
    const double fewest = std::min(kPairPoints, kPairAngle / map.bearingStep());
    visitFree(map.segment(number).slice - 1, number, map, [&](SegmentNumber other) {
        const BeamSpan& others = map.beams(other);
        const int shared = std::min(own.last, others.last) - std::max(own.first, others.first) + 1;
        const int shorter = std::min(own.last - own.first, others.last - others.first) + 1;
        if (2 * shared < shorter ||
            map.segment(other).statistics.points + map.segment(number).statistics.points < fewest)
            return;
        PairHypothesis hypothesis;
        hypothesis.segments = {other, number};
        if (!fitSegments(hypothesis.segments, map, parameters, parameters.noise.systematic, hypothesis.estimate))
            return;
        hypothesis.chi = hypothesis.estimate.chi();
        if (hypothesis.chi >= parameters.likelihood.joinGate ||
            !surelyMet(number, hypothesis.estimate, map, parameters))
            return;
        hypothesis.parallelChi = parallelChi(hypothesis.estimate, map, parameters.likelihood.knownAngle, kParallel);
        hypotheses.push_back(hypothesis);
    });
}

}  // namespace

void dropYoungGrazing(TrackMap& map, const Parameters& parameters, StepRecorder& recorder)
{
    for (std::size_t i = 0; i < map.planes().size();) {
        PlaneTrack& plane = map.planes()[i];
        if (plane.slices > kTurningSlices || !dropGrazing(plane, map, parameters, recorder))
            ++i;
    }
}

void seedTracks(TrackMap& map, int firstSlice, const Parameters& parameters, StepRecorder& recorder)
{
    std::vector<Hypothesis> hypotheses;
    for (int place = std::max(2, firstSlice); place < map.slices(); ++place) {
        for (SegmentNumber number = map.slice(place).first; number < map.slice(place).end; ++number) {
            if (map.segment(number).owner == kNoPlane)
                hypothesesOf(number, map, parameters, hypotheses);
        }
    }
    std::stable_sort(hypotheses.begin(), hypotheses.end(),
                     [](const Hypothesis& a, const Hypothesis& b) { return a.support > b.support; });
    const int step = map.slice(map.slices() - 1).step;
    for (const Hypothesis& hypothesis : hypotheses) {
        const auto& [a, b, c] = hypothesis.segments;
        if (map.segment(a).owner != kNoPlane || map.segment(b).owner != kNoPlane || map.segment(c).owner != kNoPlane)
            continue;
        PlaneTrack* plane = map.makePlane({a, b, c}, hypothesis.estimate, step, parameters);
        if (plane == nullptr)
            continue;
        if (recorder.explains())
            recorder.decide(DecisionKind::Fit, {idOf(a, map), idOf(b, map), idOf(c, map)},
                            {{"seed_chi2", hypothesis.chi, Comparison::Less, parameters.likelihood.seedGate},
                             {"normal_sigma", std::sqrt(hypothesis.normalVariance), Comparison::Less,
                              parameters.likelihood.seedAngle}},
                            {PlaneRef{plane->id}});
        growTrack(*plane, map, parameters, recorder);
    }
}

void seedPairs(TrackMap& map, const Parameters& parameters, StepRecorder& recorder)
{
    std::vector<PairHypothesis> hypotheses;
    for (int place = 1; place < map.slices(); ++place) {
        for (SegmentNumber number = map.slice(place).first; number < map.slice(place).end; ++number) {
            if (map.segment(number).owner == kNoPlane)
                pairsOf(number, map, parameters, hypotheses);
        }
    }
    std::stable_sort(hypotheses.begin(), hypotheses.end(), [](const PairHypothesis& a, const PairHypothesis& b) {
        return std::pair{a.parallelChi, a.chi} < std::pair{b.parallelChi, b.chi};
    });
    const int step = map.slice(map.slices() - 1).step;
    for (const PairHypothesis& hypothesis : hypotheses) {
        const auto& [a, b] = hypothesis.segments;
        if (map.segment(a).owner != kNoPlane || map.segment(b).owner != kNoPlane)
            continue;
        PlaneTrack* plane = map.makePlane({a, b}, hypothesis.estimate, step, parameters);
        if (plane == nullptr)
            continue;
        if (recorder.explains())
            recorder.decide(DecisionKind::Fit, {idOf(a, map), idOf(b, map)},
                            {{"pair_chi2", hypothesis.chi, Comparison::Less, parameters.likelihood.joinGate},
                             {"parallel_chi2", hypothesis.parallelChi, Comparison::LessEqual, kNoParallel}},
                            {PlaneRef{plane->id}});
        plane->ofPair = true;
        growTrack(*plane, map, parameters, recorder);
    }
}

}  // namespace planewright
