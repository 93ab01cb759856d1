// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <numbers>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <Eigen/LU>

#include "core/planes/track_publishing.h"
#include "core/planes/track_stages.h"
#include "core/types/square.h"

namespace planewright {

namespace {

/// Members of a plane in one slice or in two that follow each other.
struct Group {
    std::span<const SegmentNumber> segments;
    SegmentNumber largest = 0;  ///< by its points
    double share = 0.0;         ///< of what is known of the plane there, by the largest one: at most so much
};

/// A group of segments may decide where its plane lies if it tells more of it there than all others together. Pitch and
/// what a segment is off as a whole are left out, so that no group that does is missed; how well the others foretell it
/// settles the rest.
constexpr double kDecisiveShare = 0.5;
/// The others of a plane are so many at least of it: a half can as well be the one that is right.
constexpr std::size_t kLeastOthers = 4;
constexpr std::size_t kGroupsShare = 4;  // of the plane's segments at most one in so many is of the group
/// Another plane must foretell a segment better by so much (twice the logarithm of the likelihoods' ratio).
constexpr double kBetter = 2.0;
/// A segment that has a plane on both sides is of that one by odds of a hundred to one, whatever is measured.
const double kSurrounded = 2.0 * std::log(100.0);
constexpr double kCovered = 0.5;  // share of a segment's beams where that plane is seen next to it

/// Distance and slope of a segment: what a plane foretells of them, and what the segment tells.
struct Foretold {
    double chi = 0.0;                                   ///< of what is measured, 2 degrees of freedom
    Eigen::Matrix2d own = Eigen::Matrix2d::Zero();      ///< covariance by the plane [m², m·rad, rad²]
    Eigen::Vector2d segment = Eigen::Vector2d::Zero();  ///< variances by the segment alone
    Eigen::Vector2d floor = Eigen::Vector2d::Zero();    ///< of what a segment may be off as a whole

    /// Minus twice the logarithm of the probability density of what is measured.
    double deviance() const
    {
        Eigen::Matrix2d all = own;
        all.diagonal() += segment + floor;
        return chi + std::log(square(2.0 * std::numbers::pi) * all.determinant());
    }
    /// The largest share of what the plane knows here, distance or slope, that the segment may have told.
    double shareOfSegment() const { return (own.diagonal().array() / segment.array()).maxCoeff(); }
};

/// All but χ².
Foretold variancesAt(SegmentNumber number, PlaneTrack& plane, TrackMap& map, const Parameters& parameters)
{
    const TrackedSegment& s = map.segment(number);
    const auto& tangents = plane.estimate.tangents();
    const Eigen::Vector3d place = map.centroid(number);
    const Eigen::Vector3d along =
        map.slice(s.slice).frame.directionAt(s.statistics.directionU, s.statistics.directionV);
    Eigen::Matrix<double, 2, 3> rows;
    rows << place.transpose() * tangents, -1.0, along.transpose() * tangents, 0.0;
    const double floor = parameters.flatnessFloor();
    const double steepness = map.seenIn(plane, s.slice).steepness;
    const double length = std::max(1e-6, s.statistics.length());
    Foretold foretold;
    foretold.own = rows * plane.estimate.covariance() * rows.transpose();
    foretold.segment =
        steepness * Eigen::Vector2d(1.0 / s.statistics.offsetInformation, 1.0 / s.statistics.slopeInformation);
    foretold.floor = steepness * Eigen::Vector2d(square(floor), square(4.0 * floor / length));
    return foretold;
}

Foretold foretell(PlaneTrack& plane, SegmentNumber number, TrackMap& map, const Parameters& parameters)
{
    Foretold foretold = variancesAt(number, plane, map, parameters);
    foretold.chi = map.joinChi(plane, number, parameters.noise, parameters.flatnessFloor());
    return foretold;
}

/// The share of a segment's beams at which a plane is seen in another slice.
double coverage(SegmentNumber number, int place, PlaneId id, const TrackMap& map)
{
    if (place < 0 || place >= map.slices())
        return 0.0;
    const BeamSpan& beams = map.beams(number);
    int covered = 0;
    map.visitOverlaps(place, beams, 0, [&](SegmentNumber other) {
        const BeamSpan& there = map.beams(other);
        if (map.segment(other).owner == id)
            covered += std::min(beams.last, there.last) - std::max(beams.first, there.first) + 1;
    });
    return static_cast<double>(covered) / (beams.last - beams.first + 1);
}

bool isSurrounded(SegmentNumber number, PlaneId by, const TrackMap& map)
{
    const int place = map.segment(number).slice;
    return coverage(number, place - 1, by, map) > kCovered && coverage(number, place + 1, by, map) > kCovered;
}

struct Foreteller {
    PlaneId plane;
    double deviance;
};

/// Of the other planes that a segment faces and may join, the one that foretells it best.
std::optional<Foreteller> bestForeteller(SegmentNumber number, TrackMap& map, const Parameters& parameters)
{
    const TrackedSegment& s = map.segment(number);
    std::optional<Foreteller> best;
    std::vector<PlaneId> asked{s.owner};
    for (int place = s.slice - map.lookback(s.slice); place <= s.slice + map.lookahead(s.slice); ++place) {
        map.visitOverlaps(place, map.beams(number), kOverlapMargin, [&](SegmentNumber near) {
            const PlaneId id = map.segment(near).owner;
            if (id == kNoPlane || std::ranges::find(asked, id) != asked.end())
                return;
            asked.push_back(id);
            const Foretold there = foretell(map.plane(id), number, map, parameters);
            if (there.chi >= parameters.likelihood.joinGate)
                return;
            const double deviance = there.deviance() - (isSurrounded(number, id, map) ? kSurrounded : 0.0);
            if (!best || deviance < best->deviance)
                best = Foreteller{id, deviance};
        });
    }
    return best;
}

/// The groups of a plane that decide where it lies.
std::vector<Group> decisiveGroups(PlaneTrack& plane, TrackMap& map, const Parameters& parameters)
{
    const std::span<const SegmentNumber> members = plane.members;
    std::vector<Group> groups;
    Group before;
    const auto addIfDecisive = [&](const Group& group) {
        const std::size_t size = group.segments.size();
        if (members.size() >= std::max(size + kLeastOthers, kGroupsShare * size) &&
            group.share * static_cast<double>(size) > kDecisiveShare)
            groups.push_back(group);
    };
    const auto points = [&](SegmentNumber number) { return map.segment(number).statistics.points; };
    for (std::size_t begin = 0, end = 0; begin < members.size(); begin = end) {
        Group group;
        group.largest = members[begin];
        for (; end < members.size() && map.segment(members[end]).slice == map.segment(members[begin]).slice; ++end) {
            if (points(members[end]) > points(group.largest))
                group.largest = members[end];
        }
        group.segments = members.subspan(begin, end - begin);
        group.share = variancesAt(group.largest, plane, map, parameters).shareOfSegment();
        addIfDecisive(group);
        if (!before.segments.empty()) {
            Group both = points(group.largest) > points(before.largest) ? group : before;
            both.segments = members.subspan(begin - before.segments.size(), before.segments.size() + end - begin);
            addIfDecisive(both);
        }
        before = group;
    }
    return groups;
}

/// The segments of a group that another plane takes, which foretells the largest better.
struct Move {
    std::vector<SegmentNumber> segments;
    PlaneId to;
    Test test;

    double gain() const { return test.limit - test.value; }
};

/// Whether a group of a plane belongs to another one.
std::optional<Move> moveOf(const Group& group, const PlaneTrack& plane, TrackMap& map, const Parameters& parameters)
{
    const std::optional<Foreteller> other = bestForeteller(group.largest, map, parameters);
    if (!other)
        return std::nullopt;
    PlaneTrack others = plane;
    others.seenIn = -1;
    std::erase_if(others.members, [&](SegmentNumber number) {
        return std::ranges::find(group.segments, number) != group.segments.end();
    });
    if (!map.rebuild(others, parameters))
        return std::nullopt;
    const double own = foretell(others, group.largest, map, parameters).deviance();
    Move move{{}, other->plane, {"deviance", other->deviance, Comparison::Less, own - kBetter}};
    std::ranges::copy_if(group.segments, std::back_inserter(move.segments), [&](SegmentNumber number) {
        return map.joinChi(map.plane(other->plane), number, parameters.noise, parameters.flatnessFloor()) <
               parameters.likelihood.joinGate;
    });
    return move;
}

/// Of the groups that decide where a plane lies, the one that belongs most to another.
std::optional<Move> bestMove(PlaneTrack& plane, TrackMap& map, const Parameters& parameters)
{
    std::optional<Move> best;
    for (const Group& group : decisiveGroups(plane, map, parameters)) {
        std::optional<Move> move = moveOf(group, plane, map, parameters);
        if (move && move->test.pass() && (!best || move->gain() > best->gain()))
            best = std::move(move);
    }
    return best;
}

}  // namespace

void settleDecisive(TrackMap& map, const Parameters& parameters, StepRecorder& recorder)
{
    const int step = map.slice(map.slices() - 1).step;
    for (std::size_t i = 0; i < map.planes().size(); ++i) {
        const PlaneId id = map.planes()[i].id;
        while (const std::optional<Move> move = bestMove(map.plane(id), map, parameters)) {
            for (const SegmentNumber number : move->segments) {
                recorder.decide(DecisionKind::Assign, {idOf(number, map), PlaneRef{id}}, {move->test},
                                {PlaneRef{move->to}});
                map.segment(number).owner = move->to;
            }
            for (PlaneTrack* changed : map.collectMembers(std::vector{id, move->to}, step))
                map.rebuild(*changed, parameters);
        }
    }
}

}  // namespace planewright
