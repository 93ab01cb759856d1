// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/mapping/map_builder.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <string>
#include <utility>

#include "core/mapping/check_stop.h"
#include "core/mapping/decide_stop.h"
#include "core/mapping/map_changes.h"
#include "core/types/square.h"

namespace planewright {

namespace {

constexpr double kIndexCell = 5.0;     // [m]
constexpr std::size_t kAncestors = 3;  // of the stop before that are always looked at
constexpr double kNearShift = 0.05;    // stops that have drifted no more than this are matched as one [m]
constexpr double kNearTurn = degrees(0.3);
constexpr double kTightShift = 0.1;  // a loop that may be off by more is looked for elsewhere as well [m]

std::size_t firstPlaced(const BuildingMap& map)
{
    const auto first = std::ranges::find_if(map.stops, &MapStop::isPlaced);
    return static_cast<std::size_t>(first - map.stops.begin());
}

}  // namespace

MapBuilder::MapBuilder(const MappingParameters& parameters) : parameters_(parameters), index_(kIndexCell) {}

Result<JoinReport> MapBuilder::join(Stop given)
{
    if (const auto checked = checkStop(given); !checked)
        return tl::unexpected(checked.error());
    for (ObservedPlane& plane : given.planes)
        addFlatness(plane, parameters_.flatness);
    StopExtents extents = extentsOf(given);
    const std::size_t number = map_.stops.size();
    MapStop stop;
    stop.matches.resize(given.planes.size());
    stop.stop = std::make_shared<const Stop>(std::move(given));

    if (firstPlaced(map_) == number) {
        stop.trust = StopTrust::First;
        tree_.addRoot();
        addStop(std::move(stop), std::move(extents));
        StopMatch nothing;
        nothing.planes.resize(map_.stops[number].matches.size());
        nothing.rivals.resize(nothing.planes.size());
        nothing.joined.resize(nothing.planes.size());
        addMatches(nothing);
        return reportOf(number);
    }

    const auto expected = expectationOf(*stop.stop);
    Attempt attempt = expected ? attemptNear(*stop.stop, extents, *expected) : attemptAnywhere(*stop.stop, extents);
    const auto& [base, near, decision] = attempt;
    stop.trust = decision.trust;
    stop.alternatives = decision.alternatives;
    const Registration& registration = decision.match.registration;
    if (!stop.isPlaced()) {
        const Matrix6d nothingKnown = 1e6 * Matrix6d::Identity();
        stop.pose = expected ? expected->prior.pose : Pose{};
        tree_.add(expected ? expected->base : base, stop.pose.translation,
                  expected ? expected->prior.covariance : nothingKnown);
        stop.covariance = tree_.between(firstPlaced(map_), number, stop.pose.translation);
        addStop(std::move(stop), std::move(extents));
        return reportOf(number);
    }
    stop.pose = registration.pose;
    stop.strength = registration.strength;
    stop.odometryChiSquare = expected ? registration.priorChiSquare : 0.0;
    if (expected && stop.trust != StopTrust::AgainstOdometry)
        stop.odometry = motionOf(*expected);
    tree_.add(base, stop.pose.translation, registration.covariance);
    stop.covariance = tree_.between(firstPlaced(map_), number, stop.pose.translation);
    addStop(std::move(stop), std::move(extents));
    addMatches(decision.match);
    adjustNear(number, near);
    noteSeenThrough(number, near);

    JoinReport loop;
    closeLoop(number, base, loop);
    JoinReport report = reportOf(number);
    report.cutShort = decision.match.cutShort || loop.cutShort;
    report.closedLoop = loop.closedLoop;
    report.drift = loop.drift;
    return report;
}

MapBuilder::Attempt MapBuilder::attemptNear(const Stop& stop, const StopExtents& extents,
                                            const Expectation& expected) const
{
    const Eigen::Vector3d& place = expected.prior.pose.translation;
    const std::vector<std::size_t> around = stopsNear(place, expected.base);
    const auto attemptAt = [&](std::size_t anchor) {
        Attempt attempt{anchor, {}, {}};
        for (const std::size_t other : around) {
            if (isNear(anchor, other))
                attempt.near.push_back(other);
        }
        PosePrior prior = expected.prior;
        prior.covariance += tree_.between(expected.base, anchor, place);
        const NearPlanes planes(map_, extents_, attempt.near, tree_, anchor);
        attempt.decision = decideStop(stop, extents, planes, prior, parameters_);
        return attempt;
    };
    Attempt attempt = attemptAt(expected.base);
    if (attempt.decision.trust != StopTrust::OdometryAlone)
        return attempt;
    // The stop before saw little of what this one sees; others may have seen more, farther along the way.
    const auto other = std::ranges::find_if(around, [&](std::size_t number) { return !isNear(expected.base, number); });
    if (other == around.end())
        return attempt;
    Attempt farther = attemptAt(*other);
    return farther.decision.trust != StopTrust::OdometryAlone ? farther : attempt;
}

MapBuilder::Attempt MapBuilder::attemptAnywhere(const Stop& stop, const StopExtents& extents) const
{
    Attempt attempt{firstPlaced(map_), {}, {}};
    for (std::size_t other = 0; other < map_.stops.size(); ++other) {
        if (map_.stops[other].isPlaced())
            attempt.near.push_back(other);
    }
    const NearPlanes planes(map_, extents_, attempt.near, tree_, attempt.base);
    attempt.decision = decideStop(stop, extents, planes, parameters_);
    return attempt;
}

Result<void> MapBuilder::match(std::size_t stop, std::size_t plane, std::optional<std::size_t> mapPlane)
{
    if (stop >= map_.stops.size() || !map_.stops[stop].isPlaced() || plane >= map_.stops[stop].matches.size())
        return fail(ErrorCode::Usage, "There is no such plane of a stop that is placed in the map.");
    if (mapPlane && (*mapPlane >= map_.planes.size() || map_.planes[*mapPlane].sightings.empty()))
        return fail(ErrorCode::Usage, "The map has no plane " + std::to_string(*mapPlane) + ".");
    if (mapPlane == map_.stops[stop].matches[plane].plane && mapPlane) {
        map_.stops[stop].matches[plane].isByHand = true;
        return {};
    }
    removeSighting(map_, {stop, plane});
    MapMatch& match = map_.stops[stop].matches[plane];
    match = {mapPlane ? MatchState::Matched : MatchState::New, mapPlane, {}, 0.0, true};
    if (!mapPlane) {
        match.plane = addPlane(map_, {stop, plane});
        return {};
    }
    match.chiSquare = chiSquareOf(map_, {stop, plane}, *mapPlane);
    addSighting(map_, *mapPlane, {stop, plane});
    return {};
}

std::optional<MapBuilder::Expectation> MapBuilder::expectationOf(const Stop& stop) const
{
    if (!stop.odometry)
        return std::nullopt;
    const std::size_t last = map_.stops.size() - 1;
    std::size_t base = last;
    while (!map_.stops[base].isPlaced()) {
        if (!map_.stops[base].stop->odometry || base == 0)
            return std::nullopt;
        --base;
    }
    const Pose& before = map_.stops[last].pose;
    Expectation expected;
    expected.base = base;
    expected.prior.pose = before * stop.odometry->pose;
    expected.prior.covariance = turnedBy(before.rotation, stop.odometry->covariance) +
                                tree_.between(base, last, expected.prior.pose.translation);
    return expected;
}

StopMotion MapBuilder::motionOf(const Expectation& expected) const
{
    const Pose& from = map_.stops[expected.base].pose;
    return {expected.base,
            {from.inverse() * expected.prior.pose, turnedBy(from.rotation.conjugate(), expected.prior.covariance)}};
}

std::vector<std::size_t> MapBuilder::stopsNear(const Eigen::Vector3d& place, std::size_t base) const
{
    std::vector<std::size_t> near =
        index_.nearest(place, static_cast<std::size_t>(parameters_.nearStops), parameters_.range);
    for (std::size_t i = 0, stop = base; i <= kAncestors; ++i, stop = tree_.parentOf(stop)) {
        if (map_.stops[stop].isPlaced() && std::ranges::find(near, stop) == near.end())
            near.push_back(stop);
    }
    return near;
}

bool MapBuilder::isNear(std::size_t a, std::size_t b) const
{
    const Matrix6d drift = tree_.between(a, b, map_.stops[a].pose.translation);
    return drift.diagonal().tail<3>().maxCoeff() <= square(kNearShift) &&
           drift.diagonal().head<3>().maxCoeff() <= square(kNearTurn);
}

void MapBuilder::addStop(MapStop stop, StopExtents extents)
{
    if (stop.isPlaced())
        index_.add(map_.stops.size(), stop.pose.translation);
    map_.stops.push_back(std::move(stop));
    extents_.push_back(std::move(extents));
}

/// Of the stop that was added last.
void MapBuilder::addMatches(const StopMatch& found)
{
    const std::size_t number = map_.stops.size() - 1;
    std::map<std::size_t, std::size_t> mergedInto;
    const auto now = [&](std::size_t plane) {
        while (mergedInto.contains(plane))
            plane = mergedInto[plane];
        return plane;
    };
    std::size_t pair = 0;
    for (std::size_t i = 0; i < found.planes.size(); ++i) {
        const bool isMatched = found.planes[i].has_value();
        MapMatch& match = map_.stops[number].matches[i];
        if (isMatched)
            match.chiSquare = found.registration.pairChiSquares[pair++];
        for (const std::size_t rival : found.rivals[i])
            match.rivals.push_back(now(rival));
        if (!match.rivals.empty())
            continue;
        match.state = isMatched ? MatchState::Matched : MatchState::New;
        if (!isMatched) {
            match.plane = addPlane(map_, {number, i});
            continue;
        }
        const std::size_t plane = now(*found.planes[i]);
        match.plane = plane;
        addSighting(map_, plane, {number, i});
        for (const std::size_t piece : found.joined[i]) {
            const std::size_t other = now(piece);
            if (other == now(plane))
                continue;
            const auto [kept, gone] = std::minmax({other, now(plane)});
            mergePlanes(map_, kept, gone);
            mergedInto[gone] = kept;
        }
    }
}

void MapBuilder::closeLoop(std::size_t number, std::size_t base, JoinReport& report)
{
    const Eigen::Vector3d place = map_.stops[number].pose.translation;
    std::vector<std::size_t> older;
    std::optional<std::size_t> anchor;
    for (const std::size_t stop : stopsNear(place, base)) {
        if (stop == number || isNear(number, stop))
            continue;
        anchor = anchor.value_or(stop);  // the nearest
        if (isNear(*anchor, stop))
            older.push_back(stop);
    }
    if (!anchor)
        return;
    const NearPlanes planes(map_, extents_, older, tree_, *anchor);
    const MapStop& stop = map_.stops[number];
    const PosePrior expected{stop.pose, tree_.between(number, *anchor, place)};
    const StopMatch match = matchStop(*stop.stop, extents_[number], planes, expected, parameters_);
    report.cutShort = match.cutShort;
    bool isNews = false;
    for (std::size_t i = 0; i < match.planes.size(); ++i)
        isNews = isNews || (match.planes[i] && match.planes[i] != stop.matches[i].plane);
    if (match.pairs < parameters_.leastPairs || !isNews)
        return;

    const Pose& found = match.registration.pose;
    if (expected.covariance.bottomRightCorner<3, 3>().trace() > square(kTightShift)) {
        std::vector<Pose> rivals = rivalsOf(match, *stop.stop, extents_[number], planes, expected, parameters_);
        if (!rivals.empty()) {
            map_.stops[number].loopRivals = std::move(rivals);
            map_.stops[number].loopRivals.insert(map_.stops[number].loopRivals.begin(), found);
            return;
        }
    }

    const Vector6d drift = errorBetween(stop.pose, found);
    report.closedLoop = true;
    report.drift = drift.tail<3>().norm();
    if (!tree_.isLinked(number, *anchor, place)) {
        std::vector<Eigen::Vector3d> before;
        for (const MapStop& each : map_.stops)
            before.push_back(each.pose.translation);
        moveStops(map_, tree_.corrections(number, *anchor, carriedBy(-place) * drift));
        for (std::size_t each = 0; each < before.size(); ++each) {
            if (map_.stops[each].isPlaced() && map_.stops[each].pose.translation != before[each])
                index_.move(each, before[each], map_.stops[each].pose.translation);
        }
    }
    tree_.link(number, *anchor, place, match.registration.covariance);
    mergeWithOlder(number, match);
    adjustNear(number, older);
}

/// What the older stops know of a stop's planes: the planes of the map are one where both do.
void MapBuilder::mergeWithOlder(std::size_t number, const StopMatch& older)
{
    std::map<std::size_t, std::size_t> mergedInto;
    for (std::size_t i = 0; i < older.planes.size(); ++i) {
        if (!older.planes[i])
            continue;
        std::size_t plane = *older.planes[i];
        while (mergedInto.contains(plane))
            plane = mergedInto[plane];
        MapMatch& match = map_.stops[number].matches[i];
        if (!match.plane) {
            match = {MatchState::Matched, plane, {}, 0.0};
            addSighting(map_, plane, {number, i});
        } else if (*match.plane != plane) {
            const auto [kept, gone] = std::minmax({*match.plane, plane});
            mergePlanes(map_, kept, gone);
            mergedInto[gone] = kept;
        }
        map_.stops[number].matches[i].state = MatchState::Matched;
    }
}

void MapBuilder::noteSeenThrough(std::size_t number, std::span<const std::size_t> near)
{
    const NearPlanes planes(map_, extents_, near, tree_, number);
    for (const std::size_t plane : planesSeenThrough(map_.stops[number].pose, extents_[number], planes))
        map_.planes[plane].seenThrough.push_back(number);
}

JoinReport MapBuilder::reportOf(std::size_t number) const
{
    const MapStop& stop = map_.stops[number];
    JoinReport report;
    report.stop = number;
    report.trust = stop.trust;
    for (const MapMatch& match : stop.matches) {
        report.matched += match.state == MatchState::Matched ? 1 : 0;
        report.fresh += match.state == MatchState::New ? 1 : 0;
        report.open += match.state == MatchState::Open ? 1 : 0;
    }
    return report;
}

}  // namespace planewright
