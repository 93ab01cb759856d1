// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/mapping/decide_stop.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include <Eigen/Cholesky>

#include "core/types/square.h"

namespace planewright {

namespace {

/// With so many pairs more, another place than odometry's is the better one.
constexpr int kClearlyMore = 2;

int pairsOf(const Placement& placement)
{
    return static_cast<int>(placement.pairs.size());
}

/// Places where a stop would see through walls are left out: so many planes of the map may be glass or gone.
constexpr std::size_t kMostSeenThrough = 1;

std::vector<Placement> possiblePlaces(const Stop& stop, const StopExtents& extents, const NearPlanes& near,
                                      const std::optional<PosePrior>& about, const MappingParameters& parameters)
{
    std::vector<Placement> placements = placeStop(stop, extents, near, about, parameters);
    std::erase_if(placements, [&](const Placement& placement) {
        return planesSeenThrough(placement.pose, extents, near).size() > kMostSeenThrough;
    });
    return placements;
}

/// What each plane of a stop is in the map, by its number there.
using PlaneChoice = std::vector<std::optional<std::size_t>>;

PlaneChoice choiceOf(const Placement& placement, std::size_t planes, const NearPlanes& near)
{
    PlaneChoice choice(planes);
    for (const auto& [seen, known] : placement.pairs)
        choice[seen] = near.planes()[known].plane;
    return choice;
}

/// The placements that are rivals of a choice at a pose. What both say of a plane tells nothing of which is right; of
/// the rest a rival says about as much.
std::vector<Pose> rivalsOf(std::span<const Placement> placements, const Pose& pose, const PlaneChoice& chosen,
                           const NearPlanes& near, const MappingParameters& parameters)
{
    std::vector<Pose> rivals;
    for (const Placement& placement : placements) {
        if (isSamePlace(placement.pose, pose) || pairsOf(placement) < parameters.leastPairs)
            continue;
        const PlaneChoice other = choiceOf(placement, chosen.size(), near);
        int own = 0;
        int others = 0;
        for (std::size_t i = 0; i < chosen.size(); ++i) {
            if (chosen[i] == other[i])
                continue;
            own += chosen[i] ? 1 : 0;
            others += other[i] ? 1 : 0;
        }
        if (others > 0 && others >= parameters.rivalShare * own)
            rivals.push_back(placement.pose);
    }
    return rivals;
}

/// True where odometry allows a place.
bool isExpected(const Placement& placement, const PosePrior& expected)
{
    const Vector6d miss = errorBetween(expected.pose, placement.pose);
    const Matrix6d covariance = expected.covariance + placement.covariance;
    return miss.dot(covariance.llt().solve(miss)) < chiSquareLimit(6);
}

/// Matches at a place that was found by planes: the pose found there says no more than where to look.
StopMatch matchAt(const Placement& placement, const Stop& stop, const StopExtents& extents, const NearPlanes& near,
                  const MappingParameters& parameters)
{
    Matrix6d wide = 9.0 * placement.covariance;
    wide.diagonal().head<3>().array() += square(degrees(0.2));
    wide.diagonal().tail<3>().array() += square(0.02);
    return matchStop(stop, extents, near, {placement.pose, wide}, parameters);
}

/// Placed by planes, if they fix one place and no other.
StopDecision decideByPlanes(std::span<const Placement> placements, const Stop& stop, const StopExtents& extents,
                            const NearPlanes& near, StopTrust trust, const MappingParameters& parameters)
{
    StopDecision decision;
    const Placement& best = placements.front();
    decision.alternatives = rivalsOf(placements, best.pose, choiceOf(best, stop.planes.size(), near), near, parameters);
    if (decision.alternatives.empty() && best.fixed) {
        decision.match = matchAt(best, stop, extents, near, parameters);
        decision.trust = trust;
    } else {
        decision.alternatives.insert(decision.alternatives.begin(), best.pose);
    }
    return decision;
}

}  // namespace

StopDecision decideStop(const Stop& stop, const StopExtents& extents, const NearPlanes& near, const PosePrior& expected,
                        const MappingParameters& parameters)
{
    StopDecision decision;
    decision.match = matchStop(stop, extents, near, expected, parameters);
    const Pose& pose = decision.match.registration.pose;
    const int pairs = decision.match.pairs;
    const std::vector<Placement> placements = possiblePlaces(stop, extents, near, expected, parameters);
    const auto isHere = [&](const Placement& placement) {
        return isSamePlace(placement.pose, pose) || isExpected(placement, expected);
    };
    // At a place that odometry allows, planes count as everywhere: matched or left open.
    int here = pairs;
    for (const Placement& placement : placements)
        here = std::max(here, isHere(placement) ? pairsOf(placement) : 0);
    const auto other = std::ranges::find_if_not(placements, isHere);

    const bool otherIsBetter =
        other != placements.end() && pairsOf(*other) >= here + kClearlyMore && pairsOf(*other) > parameters.leastPairs;
    if (otherIsBetter) {
        // Odometry's own place is no rival unless it matches about as many.
        if (here < parameters.rivalShare * pairsOf(*other))
            return decideByPlanes({other, placements.end()}, stop, extents, near, StopTrust::AgainstOdometry,
                                  parameters);
        decision = {};
        decision.alternatives = rivalsOf(placements, expected.pose, PlaneChoice(stop.planes.size()), near, parameters);
        return decision;
    }
    if (pairs < parameters.leastPairs) {
        decision.trust = StopTrust::OdometryAlone;
        return decision;
    }
    decision.alternatives = rivalsOf(placements, pose, decision.match.planes, near, parameters);
    decision.trust = decision.alternatives.empty() ? StopTrust::Planes : StopTrust::OdometryDecides;
    if (decision.match.registration.priorChiSquare > chiSquareLimit(6))
        decision.trust = StopTrust::AgainstOdometry;
    return decision;
}

std::vector<Pose> rivalsOf(const StopMatch& match, const Stop& stop, const StopExtents& extents, const NearPlanes& near,
                           const PosePrior& expected, const MappingParameters& parameters)
{
    return rivalsOf(possiblePlaces(stop, extents, near, expected, parameters), match.registration.pose, match.planes,
                    near, parameters);
}

StopDecision decideStop(const Stop& stop, const StopExtents& extents, const NearPlanes& near,
                        const MappingParameters& parameters)
{
    const std::vector<Placement> placements = possiblePlaces(stop, extents, near, std::nullopt, parameters);
    if (placements.empty() || pairsOf(placements.front()) < parameters.leastPairs)
        return {};
    return decideByPlanes(placements, stop, extents, near, StopTrust::Planes, parameters);
}

}  // namespace planewright
