// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/planes/contested_tracks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "core/planes/fit_segments.h"
#include "core/planes/grow_track.h"
#include "core/planes/track_publishing.h"
#include "core/planes/track_stages.h"

namespace planewright {

namespace {

/// Segments of a run that are asked together: the fewest that tell a plane.
constexpr std::size_t kRun = 3;
/// Of these, so many belong to the plane that is asked about at least.
constexpr std::ptrdiff_t kOwn = 2;
/// Segments that are asked first: where none of them is on such a run, few are.
constexpr std::size_t kAsked = 12;
/// By how much a plane of its own may explain a run better by chance: χ² of three degrees of freedom at 97 %.
constexpr double kChance = 9.0;
/// What is left of a plane that was taken apart is none: its edges are on it still. Share of points at most.
constexpr double kMostRemains = 0.5;
/// No segment speaks louder than this χ².
constexpr double kLoudest = 16.0;
/// A run leans out of a plane if it does so by so many standard deviations of its own normal.
constexpr double kLeanSigmas = 3.0;

/// −2 ln of the likelihood of a segment's range, but for a constant: a plane met at a shallow angle lets ranges stray
/// by centimetres where a steep one lets them stray by millimetres.
double surprise(SegmentNumber number, const PlaneEstimate& plane, const TrackMap& map, const NoiseParameters& noise)
{
    const TrackedSegment& segment = map.segment(number);
    const SegmentStatistics& s = segment.statistics;
    const PlaneInSlice seen = plane.inSlice(map.slice(segment.slice).frame);
    const double distance = seen.distance.at(s.u, s.v);
    const double pitch = noise.pitch * seen.pitch.at(s.u, s.v);
    const double range = 1.0 / s.offsetInformation + noise.systematic * noise.systematic;
    const double variance = range * seen.steepness + pitch * pitch;
    return std::min(distance * distance / variance, kLoudest) + std::log(variance / seen.steepness);
}

/// The segment of the nearest slice before or after (direction −1 or 1) one that faces it most; −1 where none does.
SegmentNumber follow(SegmentNumber number, int direction, const TrackMap& map)
{
    const int place = map.segment(number).slice;
    const int reach = direction < 0 ? map.lookback(place) : map.lookahead(place);
    const BeamSpan& beams = map.beams(number);
    SegmentNumber next = -1;
    int most = 0;
    for (int away = 1; away <= reach && next < 0; ++away) {
        map.visitOverlaps(place + direction * away, beams, 0, [&](SegmentNumber other) {
            const BeamSpan& others = map.beams(other);
            const int shared = std::min(beams.last, others.last) - std::max(beams.first, others.first) + 1;
            if (shared > most) {
                most = shared;
                next = other;
            }
        });
    }
    return next;
}

/// A segment and those that follow it, of whatever planes; false where they end.
bool runFrom(SegmentNumber first, const TrackMap& map, std::array<SegmentNumber, kRun>& run)
{
    run.front() = first;
    for (std::size_t i = 1; i < kRun; ++i) {
        run[i] = follow(run[i - 1], 1, map);
        if (run[i] < 0)
            return false;
    }
    return true;
}

/// A run of a plane that leans out of it.
struct LeaningRun {
    std::array<SegmentNumber, kRun> segments{};
    PlaneEstimate own;
    double gain = 0.0;  ///< χ² by which its own plane explains it better
};

/// Whether a chord turns that far out of a plane: a cheap question that most runs deny.
bool mayLean(const LeaningRun& run, const PlaneEstimate& whole, const TrackMap& map, double lean)
{
    const Eigen::Vector3d along = directionOf(run.segments.front(), map);
    const Eigen::Vector3d chord = map.centroid(run.segments.back()) - map.centroid(run.segments.front());
    const double across = chord.cross(along).norm();
    return std::abs(whole.normal().dot(chord - chord.dot(along) * along)) > std::sin(lean) * across;
}

bool leansOut(LeaningRun& run, PlaneId id, const PlaneEstimate& whole, const TrackMap& map,
              const Parameters& parameters)
{
    if (!mayLean(run, whole, map, parameters.planes.runLean) ||
        !fitSegments(run.segments, map, parameters, parameters.noise.systematic, run.own))
        return false;
    const double lean = std::acos(std::min(1.0, std::abs(run.own.normal().dot(whole.normal()))));
    if (lean < std::max(parameters.planes.runLean, kLeanSigmas * std::sqrt(run.own.normalVariance())))
        return false;
    const PlaneEstimate own(run.own.normal(), run.own.distance());
    run.gain = 0.0;
    for (const SegmentNumber number : run.segments) {
        if (map.segment(number).owner == id)
            run.gain += surprise(number, whole, map, parameters.noise) - surprise(number, own, map, parameters.noise);
    }
    return run.gain > kChance;
}

/// The runs that lean out of a plane, from its first segment on.
std::vector<LeaningRun> leaningRuns(const PlaneTrack& plane, const TrackMap& map, const Parameters& parameters)
{
    std::vector<LeaningRun> leaning;
    if (meanErrorOf(plane) <= largestMeanError(plane, parameters))
        return leaning;
    const PlaneEstimate whole(plane.estimate.normal(), plane.estimate.distance());
    const auto isOwn = [&](SegmentNumber number) { return map.segment(number).owner == plane.id; };
    const auto ask = [&](SegmentNumber first) {
        LeaningRun run;
        if (runFrom(first, map, run.segments) &&
            std::count_if(run.segments.begin(), run.segments.end(), isOwn) >= kOwn &&
            leansOut(run, plane.id, whole, map, parameters))
            leaning.push_back(run);
    };
    const auto askAbout = [&](SegmentNumber number) {
        const SegmentNumber before = follow(number, -1, map);
        if (before >= 0 && !isOwn(before))
            ask(before);
        ask(number);
    };
    const std::size_t stride = plane.members.size() / kAsked + 1;
    for (std::size_t i = 0; i < plane.members.size(); i += stride)
        askAbout(plane.members[i]);
    if (leaning.empty())
        return leaning;
    leaning.clear();
    std::for_each(plane.members.begin(), plane.members.end(), askAbout);
    return leaning;
}

double shareOf(const std::vector<LeaningRun>& runs, const PlaneTrack& plane, const TrackMap& map)
{
    std::vector<SegmentNumber> on;
    for (const LeaningRun& run : runs)
        std::copy_if(run.segments.begin(), run.segments.end(), std::back_inserter(on),
                     [&](SegmentNumber number) { return map.segment(number).owner == plane.id; });
    std::sort(on.begin(), on.end());
    on.erase(std::unique(on.begin(), on.end()), on.end());
    double points = 0.0;
    for (const SegmentNumber number : on)
        points += map.segment(number).statistics.points;
    return points / static_cast<double>(plane.points);
}

/// Share of a plane's points that were on planes taken apart before, which it lies like.
double shareOfRemains(const PlaneTrack& plane, const TrackMap& map, const Parameters& parameters)
{
    double points = 0.0;
    for (const SegmentNumber number : plane.members) {
        const TrackedSegment& segment = map.segment(number);
        if (segment.contested < 0)
            continue;
        const PlaneEstimate& before = map.contestedPlanes[static_cast<std::size_t>(segment.contested)];
        if (std::abs(before.normal().dot(plane.estimate.normal())) > std::cos(parameters.planes.runLean))
            points += segment.statistics.points;
    }
    return points / static_cast<double>(plane.points);
}

/// Makes planes of runs that were freed, those first of which their own explains most.
void makePlanesOf(std::vector<LeaningRun>& freed, TrackMap& map, const Parameters& parameters, StepRecorder& recorder)
{
    const int step = map.slice(map.slices() - 1).step;
    std::stable_sort(freed.begin(), freed.end(),
                     [](const LeaningRun& a, const LeaningRun& b) { return a.gain > b.gain; });
    for (const LeaningRun& run : freed) {
        if (std::any_of(run.segments.begin(), run.segments.end(),
                        [&](SegmentNumber number) { return map.segment(number).owner != kNoPlane; }))
            continue;
        const auto make = [&] {
            PlaneTrack* plane = map.makePlane({run.segments.begin(), run.segments.end()}, run.own, step, parameters);
            if (plane != nullptr && recorder.explains())
                recorder.decide(DecisionKind::Fit,
                                {idOf(run.segments[0], map), idOf(run.segments[1], map), idOf(run.segments[2], map)},
                                {{"run_gain", run.gain, Comparison::Greater, kChance}}, {PlaneRef{plane->id}});
            return plane;
        };
        PlaneTrack* plane = make();
        // The edges of a stair may turn a young plane until it is none; the run is still one.
        if (plane != nullptr && !growTrack(*plane, map, parameters, recorder))
            make();
    }
}

}  // namespace

double contestedShare(const PlaneTrack& plane, const TrackMap& map, const Parameters& parameters)
{
    return shareOf(leaningRuns(plane, map, parameters), plane, map);
}

void splitContested(TrackMap& map, const Parameters& parameters, StepRecorder& recorder)
{
    std::vector<LeaningRun> freed;
    for (std::size_t i = 0; i < map.planes().size();) {
        PlaneTrack& plane = map.planes()[i];
        if (std::exchange(plane.contestedAt, plane.points) == plane.points) {
            ++i;
            continue;
        }
        const std::vector<LeaningRun> runs = leaningRuns(plane, map, parameters);
        const Test contested{"contested_share", shareOf(runs, plane, map), Comparison::Greater,
                             parameters.planes.maxContested};
        const Test remains{"contested_remains", shareOfRemains(plane, map, parameters), Comparison::Greater,
                           kMostRemains};
        if (!contested.pass() && !remains.pass()) {
            ++i;
            continue;
        }
        recorder.decide(DecisionKind::Split, {PlaneRef{plane.id}}, {contested.pass() ? contested : remains});
        ++recorder.counts().splits;
        if (contested.pass()) {
            freed.insert(freed.end(), runs.begin(), runs.end());
            for (const SegmentNumber number : plane.members)
                map.segment(number).contested = static_cast<int>(map.contestedPlanes.size());
            map.contestedPlanes.push_back(plane.estimate);
        }
        map.dissolve(plane.id);
    }
    makePlanesOf(freed, map, parameters, recorder);
}

}  // namespace planewright
