// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/planes/track_publishing.h"
#include "core/planes/track_stages.h"

namespace planewright {

namespace {

/// A segment with a smaller χ² stays where it is; another plane must be better by as much.
constexpr double kContent = 2.0;
/// Mean squared residual of a straight segment at most, beside its scatter: sensors are noisier than told.
constexpr double kStraightChi = 2.0;
/// However coarse the scan, a plane has so many points.
constexpr double kFewestPoints = 12.0;
/// And as many that do not lie one upon the other next to the pitch axis.
constexpr double kFewestSpreadPoints = 10.0;
/// Planes of more segments are not thinned out one by one.
constexpr std::size_t kThinned = 60;

constexpr double kInfinite = std::numeric_limits<double>::infinity();

/// Whether a segment fits another plane so much better than its own that it moves.
Test moveTest(double chi, double own)
{
    return {"moved_chi2", chi + kContent, Comparison::Less, own};
}

struct Better {
    PlaneTrack* plane = nullptr;
    double chi;
};

/// The best plane among those of the segments around one that it may join.
Better bestAround(SegmentNumber number, TrackMap& map, const Parameters& parameters)
{
    const TrackedSegment& s = map.segment(number);
    Better best{nullptr, parameters.likelihood.joinGate};
    for (int place = s.slice - map.lookback(s.slice); place <= s.slice + map.lookahead(s.slice); ++place) {
        map.visitOverlaps(place, map.beams(number), kOverlapMargin, [&](SegmentNumber other) {
            const PlaneId owner = map.segment(other).owner;
            if (owner == kNoPlane || owner == s.owner || (best.plane != nullptr && best.plane->id == owner))
                return;
            PlaneTrack& plane = map.plane(owner);
            const double chi = map.joinChi(plane, number, parameters.noise, parameters.flatnessFloor(), best.chi);
            if (chi < best.chi)
                best = {&plane, chi};
        });
    }
    return best;
}

/// Mean width of a plane's segments [m] and the share of slices in which it stands free on both sides.
struct Strip {
    double width = 0.0;
    double freeShare = 0.0;
};

Strip stripOf(const PlaneTrack& plane, const TrackMap& map)
{
    Strip strip;
    int free = 0;
    int slices = 0;
    for (std::size_t i = 0; i < plane.members.size();) {
        const int place = map.segment(plane.members[i]).slice;
        const TrackedSegment& first = map.segment(plane.members[i]);
        double width = 0.0;
        std::size_t last = i;
        for (; i < plane.members.size() && map.segment(plane.members[i]).slice == place; ++i) {
            width += map.segment(plane.members[i]).statistics.length();
            last = i;
        }
        strip.width += width;
        ++slices;
        free += first.statistics.startsFree && map.segment(plane.members[last]).statistics.endsFree ? 1 : 0;
    }
    strip.width /= slices;
    strip.freeShare = static_cast<double>(free) / slices;
    return strip;
}

/// Share of a plane's points in segments that are no straight lines.
double bentShare(const PlaneTrack& plane, const TrackMap& map)
{
    std::int64_t bent = 0;
    for (const SegmentNumber number : plane.members) {
        const SegmentStatistics& s = map.segment(number).statistics;
        const double freedom = std::max(1.0, s.points - 2.0);
        // The first question is enough for most, and spares them the root.
        if (s.chi > kStraightChi * freedom && s.chi > kStraightChi * (freedom + 4.0 * std::sqrt(2.0 * freedom)))
            bent += s.points;
    }
    return static_cast<double>(bent) / static_cast<double>(plane.points);
}

/// How many of a plane's points there would be if all its beams were as far apart as those of neighbouring slices are
/// at right angles to the pitch axis: next to that axis all slices look the same way, and any number of points fills no
/// area that would tell a plane.
double spreadPoints(const PlaneTrack& plane, const TrackMap& map)
{
    double sum = 0.0;
    for (const SegmentNumber number : plane.members) {
        const SegmentStatistics& s = map.segment(number).statistics;
        sum += s.points * std::abs(s.v) / std::hypot(s.u, s.v);
    }
    return sum;
}

/// Degrees of freedom of a plane's χ²: two numbers a segment, less three of the plane.
double freedomOfMembers(const PlaneTrack& plane)
{
    return std::max(1.0, 2.0 * static_cast<double>(plane.members.size()) - 3.0);
}

/// Mean of its segments' squared residuals, beside what real walls stray.
double reducedChi(PlaneTrack& plane, TrackMap& map, const Parameters& parameters)
{
    if (map.holds(plane, plane.reducedAt))
        return plane.reducedChi;
    std::vector<double> chis(plane.members.size());
    plane.estimate.residualChis(map.together(plane.members), parameters.noise, parameters.flatnessFloor(), chis);
    plane.reducedChi = std::accumulate(chis.begin(), chis.end(), 0.0) / freedomOfMembers(plane);
    plane.reducedAt = map.moment();
    return plane.reducedChi;
}

/// χ² of each segment against the plane that it belongs to, by its number.
std::vector<double> chisOfMembers(TrackMap& map, const Parameters& parameters)
{
    std::vector<double> all(static_cast<std::size_t>(map.segments()));
    std::vector<double> chis;
    for (const PlaneTrack& plane : map.planes()) {
        chis.resize(plane.members.size());
        plane.estimate.joinChis(map.together(plane.members), parameters.noise, parameters.flatnessFloor(), kInfinite,
                                chis);
        for (std::size_t i = 0; i < chis.size(); ++i)
            all[static_cast<std::size_t>(plane.members[i])] = chis[i];
    }
    return all;
}

}  // namespace

void splitTracks(TrackMap& map, const Parameters& parameters, StepRecorder& recorder)
{
    const int step = map.slice(map.slices() - 1).step;
    const std::vector<double> chis = chisOfMembers(map, parameters);
    std::vector<PlaneId> changed;
    for (SegmentNumber number = 0; number < map.segments(); ++number) {
        const PlaneId owner = map.segment(number).owner;
        const double chi = chis[static_cast<std::size_t>(number)];
        if (owner == kNoPlane || chi <= kContent)
            continue;
        const Better better = bestAround(number, map, parameters);
        const double gate = parameters.likelihood.joinGate;
        const bool goes = better.plane != nullptr && moveTest(better.chi, chi).pass();
        if (!goes && chi < gate)
            continue;
        if (recorder.explains()) {
            if (goes)
                recorder.decide(DecisionKind::Assign, {idOf(number, map), PlaneRef{owner}},
                                {{"join_chi2", better.chi, Comparison::Less, chi - kContent}},
                                {PlaneRef{better.plane->id}});
            else
                recorder.decide(DecisionKind::Reject, {idOf(number, map), PlaneRef{owner}},
                                {{"join_chi2", chi, Comparison::Less, gate}});
        }
        changed.push_back(owner);
        if (goes)
            changed.push_back(better.plane->id);
        if (goes)
            map.segment(number).owner = better.plane->id;
        else
            map.free(number);
    }
    for (PlaneTrack* plane : map.collectMembers(changed, step))
        map.rebuild(*plane, parameters);
}

Conditions wayToMove(SegmentNumber number, PlaneTrack& plane, TrackMap& map, const Parameters& parameters)
{
    const double floor = parameters.flatnessFloor();
    PlaneTrack& own = map.plane(map.segment(number).owner);
    const double chi = map.joinChi(plane, number, parameters.noise, floor);
    const double chiOfOwn = map.joinChi(own, number, parameters.noise, floor);
    return {"move",
            {{"own_chi2", chiOfOwn, Comparison::Greater, kContent},
             {"join_chi2", chi, Comparison::Less, parameters.likelihood.joinGate},
             moveTest(chi, chiOfOwn)}};
}

void thinTracks(TrackMap& map, const Parameters& parameters, StepRecorder& recorder)
{
    const int step = map.slice(map.slices() - 1).step;
    std::vector<PlaneId> thinned;
    std::vector<double> chis;
    for (PlaneTrack& plane : map.planes()) {
        const std::size_t before = plane.members.size();
        while (plane.members.size() > 3 && plane.members.size() <= kThinned) {
            const double limit = parameters.likelihood.largestReducedChi(freedomOfMembers(plane));
            const double reduced = reducedChi(plane, map, parameters);
            if (reduced <= limit)
                break;
            chis.resize(plane.members.size());
            plane.estimate.joinChis(map.together(plane.members), parameters.noise, parameters.flatnessFloor(),
                                    kInfinite, chis);
            const auto worst = plane.members.begin() + (std::max_element(chis.begin(), chis.end()) - chis.begin());
            recorder.decide(DecisionKind::Split, {PlaneRef{plane.id}, idOf(*worst, map)},
                            {{"reduced_chi2", reduced, Comparison::Greater, limit}}, {PlaneRef{plane.id}});
            map.free(*worst);
            plane.members.erase(worst);
            map.stamp(plane);
            if (!map.rebuild(plane, parameters))
                break;
        }
        if (plane.members.size() < before)
            thinned.push_back(plane.id);
    }
    recorder.counts().splits += static_cast<int>(thinned.size());
    map.collectMembers(thinned, step);
}

void dropUnfounded(TrackMap& map, const Parameters& parameters, StepRecorder& recorder)
{
    const LikelihoodParameters& p = parameters.likelihood;
    const double beamSolidAngle = map.bearingStep() * map.meanTiltStep();
    const double minPoints = std::clamp(p.minSolidAngle / std::max(beamSolidAngle, 1e-9), kFewestPoints,
                                        std::max(kFewestPoints, static_cast<double>(p.enoughPoints)));
    std::vector<PlaneId> unfounded;
    for (PlaneTrack& plane : map.planes()) {
        if (map.holds(plane, plane.foundedAt))
            continue;
        const Strip strip = stripOf(plane, map);
        std::vector<Test> tests{
            {"points", static_cast<double>(plane.points), Comparison::GreaterEqual, minPoints},
            {"spread_points", spreadPoints(plane, map), Comparison::GreaterEqual, kFewestSpreadPoints},
            {"segments", static_cast<double>(plane.members.size()), Comparison::GreaterEqual,
             plane.ofPair ? 2.0 : static_cast<double>(parameters.planes.minSegments)},
            {"slices", static_cast<double>(plane.slices), Comparison::GreaterEqual,
             plane.ofPair ? 2.0 : static_cast<double>(parameters.planes.minSlices)},
        };
        if (strip.width < p.stripWidth)
            tests.push_back({"free_strip_share", strip.freeShare, Comparison::LessEqual, p.stripShare});
        if (plane.members.size() <= kThinned)
            tests.push_back({"reduced_chi2", reducedChi(plane, map, parameters), Comparison::LessEqual,
                             p.largestReducedChi(freedomOfMembers(plane))});
        tests.push_back({"bent_share", bentShare(plane, map), Comparison::LessEqual, p.bentShare});
        tests.push_back({"incidence", map.meanIncidence(plane), Comparison::GreaterEqual,
                         std::sin(parameters.planes.minIncidence)});
        // Where ranges err together, what noise makes of a normal does not tell how well it is known.
        if (parameters.noise.systematic <= 0.0)
            tests.push_back({"normal_sigma",
                             std::sqrt(std::max(1.0, meanErrorOf(plane)) * plane.estimate.normalVariance()),
                             Comparison::LessEqual, parameters.planes.maxNormalSigma});
        if (std::all_of(tests.begin(), tests.end(), [](const Test& test) { return test.pass(); })) {
            plane.foundedAt = map.moment();
            continue;
        }
        unfounded.push_back(plane.id);
        recorder.decide(DecisionKind::NoFit, {PlaneRef{plane.id}}, tests);
    }
    for (const PlaneId id : unfounded)
        map.dissolve(id);
}

}  // namespace planewright
