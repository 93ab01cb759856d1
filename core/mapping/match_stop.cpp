// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/mapping/match_stop.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include "core/mapping/match_jointly.h"

namespace planewright {

namespace {

/// How far outlines may lie apart for an error of the pose: two standard deviations of the shift that is known worst,
/// and of a turn at a few metres.
double slackOf(const Matrix6d& covariance)
{
    constexpr double kLever = 4.0;      // [m]
    constexpr double kMostSlack = 1.0;  // [m]
    const Eigen::Matrix3d shift = covariance.bottomRightCorner<3, 3>();
    const Eigen::Matrix3d turn = covariance.topLeftCorner<3, 3>();
    return std::min(kMostSlack, 2.0 * std::sqrt(shift.eigenvalues().real().maxCoeff() +
                                                kLever * kLever * turn.eigenvalues().real().maxCoeff()));
}

bool shareCandidate(const MatchChoices& a, const MatchChoices& b)
{
    return std::ranges::any_of(a.candidates, [&b](const MatchCandidate& candidate) {
        return std::ranges::find(b.candidates, candidate.known, &MatchCandidate::known) != b.candidates.end();
    });
}

/// What each of a stop's planes may be, compared about the place where the stop is expected.
std::vector<MatchChoices> choicesOf(const Stop& stop, const StopExtents& extents, const NearPlanes& near,
                                    const PosePrior& expected, double gap, const MatchLimits& limits)
{
    std::vector<MatchChoices> choices(stop.planes.size());
    for (std::size_t i = 0; i < stop.planes.size(); ++i) {
        const Eigen::Vector3d middle = expected.pose * middleOf(stop.planes[i]);
        const Pose fromMiddle{expected.pose.rotation, expected.pose.translation - middle};
        const UncertainPlane seen = inMap(stop.planes[i].parameters, fromMiddle);
        choices[i].jacobian = poseJacobian(seen, fromMiddle);
        const Eigen::Matrix3d byPose = choices[i].jacobian * expected.covariance * choices[i].jacobian.transpose();
        for (std::size_t j = 0; j < near.planes().size(); ++j) {
            const UncertainPlane& plane = near.planes()[j].parameters;
            if (seen.normal.dot(plane.normal) <= 0.0)
                continue;
            const UncertainPlane known = seenFrom(plane, middle);
            const Eigen::Vector3d apart = difference(seen, known);
            const Eigen::Matrix3d noise = seen.covariance + covarianceIn(seen, known);
            if (apart.dot((noise + byPose).llt().solve(apart)) < limits.gate &&
                near.meets(extents[i], expected.pose, j, gap))
                choices[i].candidates.push_back({j, apart, noise});
        }
    }
    for (std::size_t i = 0; i < choices.size(); ++i) {
        const Eigen::Vector3d middle = middleOf(stop.planes[i]);
        const UncertainPlane own = seenFrom(stop.planes[i].parameters, middle);
        for (std::size_t k = 0; k < i; ++k) {
            if (!shareCandidate(choices[i], choices[k]) ||
                chiSquare(own, seenFrom(stop.planes[k].parameters, middle)) < limits.gate)
                continue;
            choices[i].others.push_back(k);
            choices[k].others.push_back(i);
        }
    }
    return choices;
}

/// A pair that nothing but odometry vouches for, when the plane was looked for within this [m] or more, must have been
/// seen in places of which one covers so much of the other: what was there before is not seen through what is new. Else
/// it may as well be another plane.
constexpr double kVouchedFor = 0.03;
constexpr double kCovered = 0.6;

/// True where two planes near by are pieces of one that were seen apart: they nowhere overlap, and are one plane by
/// numbers that would tell them apart if they were not.
bool arePieces(const NearPlanes& near, std::size_t a, std::size_t b, const Eigen::Vector3d& place, double gate)
{
    constexpr double kTellsApart = 0.02;  // standard deviation [m]
    const UncertainPlane one = seenFrom(near.planes()[a].parameters, place);
    const UncertainPlane other = seenFrom(near.planes()[b].parameters, place);
    return chiSquare(one, other) < gate && std::sqrt(one.covariance(2, 2) + other.covariance(2, 2)) < kTellsApart &&
           !near.overlap(a, b);
}

}  // namespace

StopMatch matchStop(const Stop& stop, const StopExtents& extents, const NearPlanes& near, const PosePrior& expected,
                    const MappingParameters& parameters)
{
    const MatchLimits limits;
    const std::size_t count = stop.planes.size();
    const double gap = parameters.gap + slackOf(expected.covariance);
    const auto choices = choicesOf(stop, extents, near, expected, gap, limits);
    const JointMatch joint = matchJointly(choices, expected.covariance, limits);

    StopMatch match;
    match.planes.resize(count);
    match.rivals.resize(count);
    match.joined.resize(count);
    match.cutShort = joint.cutShort;
    std::vector<std::size_t> paired;
    std::vector<MatchedPlanes> pairs;
    const auto nearOf = [&](std::size_t i, std::size_t candidate) { return choices[i].candidates[candidate].known; };
    for (std::size_t i = 0; i < count; ++i) {
        if (!joint.chosen[i])
            continue;
        paired.push_back(i);
        pairs.push_back({stop.planes[i].parameters, near.planes()[nearOf(i, *joint.chosen[i])].parameters,
                         middleOf(stop.planes[i])});
    }
    const auto first = registerPlanes(pairs, expected);
    if (!first)
        return match;
    match.registration = *first;

    // At the pose that they give, outlines must meet without the allowance for where the stop was expected.
    const double closeGap = parameters.gap + slackOf(first->covariance);
    const auto meetsNow = [&](std::size_t i, std::size_t candidate) {
        return near.meets(extents[i], first->pose, nearOf(i, candidate), closeGap);
    };
    std::vector<MatchedPlanes> kept;
    for (std::size_t n = 0; n < paired.size(); ++n) {
        const std::size_t i = paired[n];
        for (const std::size_t rival : joint.rivals[i]) {
            if (!meetsNow(i, rival))
                continue;
            const bool isPiece =
                arePieces(near, nearOf(i, *joint.chosen[i]), nearOf(i, rival), first->pose.translation, limits.gate);
            (isPiece ? match.joined : match.rivals)[i].push_back(near.planes()[nearOf(i, rival)].plane);
        }
        const std::size_t chosen = nearOf(i, *joint.chosen[i]);
        if (!meetsNow(i, *joint.chosen[i]))
            continue;
        const bool isVouchedFor = !joint.isContested[i] && (joint.looseness[i] <= kVouchedFor ||
                                                            near.coverage(extents[i], first->pose, chosen) >= kCovered);
        if (!match.rivals[i].empty() || !isVouchedFor) {
            match.rivals[i].insert(match.rivals[i].begin(), near.planes()[chosen].plane);
            continue;
        }
        match.planes[i] = near.planes()[chosen].plane;
        kept.push_back(pairs[n]);
        ++match.pairs;
    }
    if (kept.size() < pairs.size()) {
        if (const auto again = registerPlanes(kept, expected))
            match.registration = *again;
    }
    return match;
}

std::vector<Placement> placeStop(const Stop& stop, const StopExtents& extents, const NearPlanes& near,
                                 const std::optional<PosePrior>& about, const MappingParameters& parameters)
{
    std::vector<WeighedPlane> seen;
    for (std::size_t i = 0; i < stop.planes.size(); ++i)
        seen.push_back({stop.planes[i].parameters, areaOf(extents[i])});
    PlacementSearch search;
    search.tilt = parameters.searchTilt;
    if (about) {
        search.about = about->pose;
        const Eigen::Matrix3d shift = about->covariance.bottomRightCorner<3, 3>();
        search.reach = parameters.searchReach + 3.0 * std::sqrt(shift.eigenvalues().real().maxCoeff());
    }
    return placeByPlanes(seen, near.weighed(), search, [&](std::size_t i, std::size_t j, const Pose& pose) {
        return near.meets(extents[i], pose, j, parameters.gap);
    });
}

}  // namespace planewright
