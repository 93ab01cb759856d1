// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/mapping/place_by_planes.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include "core/mapping/match_jointly.h"
#include "core/mapping/register_planes.h"
#include "core/types/square.h"

namespace planewright {

namespace {

constexpr double kSameDirection = degrees(3.0);
constexpr double kSamePlace = 0.2;     // [m]
constexpr double kSameDistance = 0.1;  // of a plane, at a place found from three others [m]
constexpr double kTurnSpread = degrees(1.0);
constexpr std::size_t kMostRotations = 64;
constexpr std::size_t kMostTriples = 6;
constexpr std::size_t kMostTrials = 4000;  // of triples, for each rotation
constexpr std::size_t kMostRefined = 8;

/// Numbers of planes, the largest first.
std::vector<std::size_t> bySize(std::span<const WeighedPlane> planes, std::size_t most)
{
    std::vector<std::size_t> order(planes.size());
    for (std::size_t i = 0; i < order.size(); ++i)
        order[i] = i;
    std::ranges::stable_sort(order, std::ranges::greater{}, [&](std::size_t i) { return planes[i].area; });
    order.resize(std::min(most, order.size()));
    return order;
}

Eigen::Matrix3d triad(const Eigen::Vector3d& first, const Eigen::Vector3d& second)
{
    Eigen::Matrix3d axes;
    axes.col(0) = first;
    axes.col(2) = first.cross(second).normalized();
    axes.col(1) = axes.col(2).cross(first);
    return axes;
}

double turnBetween(const Eigen::Quaterniond& a, const Eigen::Quaterniond& b)
{
    return rotationVector(a * b.conjugate()).norm();
}

/// Rotations by which pairs of the stop's largest planes lie as pairs of the map do, each once; the most frequent
/// first.
std::vector<Eigen::Quaterniond> rotationsOf(std::span<const WeighedPlane> seen, std::span<const WeighedPlane> known,
                                            double tilt)
{
    struct Vote {
        Eigen::Quaterniond rotation;
        int votes;
    };
    constexpr double kLeastAngle = degrees(30.0);
    constexpr int kMostPairs = 6;
    std::vector<Vote> found;
    const std::vector<std::size_t> largest = bySize(seen, 6);
    const double upright = std::cos(std::min(tilt, 3.1416));
    int pairs = 0;
    for (std::size_t a = 0; a < largest.size() && pairs < kMostPairs; ++a) {
        for (std::size_t b = a + 1; b < largest.size() && pairs < kMostPairs; ++b) {
            const Eigen::Vector3d& first = seen[largest[a]].parameters.normal;
            const Eigen::Vector3d& second = seen[largest[b]].parameters.normal;
            const double angle = std::atan2(first.cross(second).norm(), first.dot(second));
            if (std::sin(angle) < std::sin(kLeastAngle))
                continue;
            ++pairs;
            const Eigen::Matrix3d back = triad(first, second).transpose();
            const double low = std::cos(std::min(angle + kSameDirection, 3.1416));
            const double high = std::cos(std::max(angle - kSameDirection, 0.0));
            for (const WeighedPlane& one : known) {
                // The height of the first normal is kept by an upright stop.
                if (std::abs(std::asin(std::clamp(one.parameters.normal.z(), -1.0, 1.0)) -
                             std::asin(std::clamp(first.z(), -1.0, 1.0))) > tilt + kSameDirection)
                    continue;
                for (const WeighedPlane& other : known) {
                    const double cosine = one.parameters.normal.dot(other.parameters.normal);
                    if (cosine < low || cosine > high)
                        continue;
                    const Eigen::Matrix3d turn = triad(one.parameters.normal, other.parameters.normal) * back;
                    if (turn(2, 2) < upright)
                        continue;
                    const Eigen::Quaterniond rotation(turn);
                    const auto same = std::ranges::find_if(
                        found, [&](const Vote& vote) { return turnBetween(vote.rotation, rotation) < kSameDirection; });
                    if (same != found.end())
                        ++same->votes;
                    else if (found.size() < kMostRotations)
                        found.push_back({rotation, 1});
                }
            }
        }
    }
    std::ranges::stable_sort(found, std::ranges::greater{}, &Vote::votes);
    std::vector<Eigen::Quaterniond> rotations;
    for (const Vote& vote : found)
        rotations.push_back(vote.rotation);
    return rotations;
}

/// A shift to try, and how many of the stop's planes find one of the map there.
struct Trial {
    Pose pose;
    Eigen::Matrix3d free;  ///< covariance of what the planes tried do not fix [m²]
    int fits;
};

/// The stop's planes under one rotation, with the planes of the map that each may be.
class ShiftSearch {
public:
    ShiftSearch(std::span<const WeighedPlane> seen, std::span<const WeighedPlane> known,
                const Eigen::Quaterniond& rotation, const PlacementSearch& search, int& mostFits)
        : search_(search),
          rotation_(rotation),
          centre_(search.about ? search.about->translation : Eigen::Vector3d::Zero()),
          mostFits_(mostFits)
    {
        const double least = std::cos(kSameDirection);
        offsets_.resize(seen.size());
        for (std::size_t i = 0; i < seen.size(); ++i) {
            const Eigen::Vector3d normal = rotation * seen[i].parameters.normal;
            normals_.push_back(normal);
            for (const WeighedPlane& plane : known) {
                const double offset =
                    plane.parameters.distance - plane.parameters.normal.dot(centre_) - seen[i].parameters.distance;
                if (normal.dot(plane.parameters.normal) > least && std::abs(offset) <= search.reach + kSameDistance)
                    offsets_[i].push_back({plane.parameters.normal, offset});
            }
        }
    }

    void run(const std::vector<std::size_t>& largest, std::vector<Trial>& trials) const
    {
        std::size_t triples = 0;
        std::size_t tried = 0;
        for (std::size_t a = 0; a < largest.size(); ++a) {
            for (std::size_t b = a + 1; b < largest.size(); ++b) {
                for (std::size_t c = b + 1; c < largest.size() && triples < kMostTriples; ++c) {
                    const std::size_t i = largest[a];
                    const std::size_t j = largest[b];
                    const std::size_t k = largest[c];
                    if (std::abs(normals_[i].dot(normals_[j].cross(normals_[k]))) < 0.3 || offsets_[i].empty() ||
                        offsets_[j].empty() || offsets_[k].empty())
                        continue;
                    ++triples;
                    for (const Offset& first : offsets_[i]) {
                        for (const Offset& second : offsets_[j]) {
                            for (const Offset& third : offsets_[k]) {
                                if (++tried <= kMostTrials)
                                    tryShift({first, second, third}, trials);
                            }
                        }
                    }
                }
            }
        }
        if (triples == 0)
            tryPairs(largest, trials);
    }

private:
    struct Offset {
        Eigen::Vector3d normal;
        double offset;  ///< the shift from the centre that is asked for along the normal [m]
    };

    /// No three planes fix the shift: what two do not is left where the stop is expected.
    void tryPairs(const std::vector<std::size_t>& largest, std::vector<Trial>& trials) const
    {
        if (!search_.about)
            return;
        std::size_t tried = 0;
        for (std::size_t a = 0; a < largest.size(); ++a) {
            for (std::size_t b = a + 1; b < largest.size(); ++b) {
                if (normals_[largest[a]].cross(normals_[largest[b]]).norm() < 0.5)
                    continue;
                for (const Offset& first : offsets_[largest[a]]) {
                    for (const Offset& second : offsets_[largest[b]]) {
                        if (++tried <= kMostTrials)
                            tryShift({first, second}, trials);
                    }
                }
            }
        }
    }

    void tryShift(std::initializer_list<Offset> offsets, std::vector<Trial>& trials) const
    {
        Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
        Eigen::Vector3d asked = Eigen::Vector3d::Zero();
        for (const Offset& each : offsets) {
            sum += each.normal * each.normal.transpose();
            asked += each.offset * each.normal;
        }
        Eigen::Matrix3d free = Eigen::Matrix3d::Zero();
        if (offsets.size() < 3) {
            const Eigen::Vector3d open = offsets.begin()[0].normal.cross(offsets.begin()[1].normal).normalized();
            free = square(std::min(search_.reach, 100.0)) * open * open.transpose();
            sum += open * open.transpose();
        }
        const Eigen::Vector3d shift = sum.inverse() * asked;
        if (shift.norm() > search_.reach)
            return;
        int fits = 0;
        for (const auto& of : offsets_) {
            fits += std::ranges::any_of(
                of, [&](const Offset& each) { return std::abs(each.offset - each.normal.dot(shift)) < kSameDistance; });
        }
        // Far fewer fits than the best so far: not worth a closer look.
        if (!trials.empty() && 2 * fits < mostFits_)
            return;
        mostFits_ = std::max(mostFits_, fits);
        trials.push_back({{rotation_, centre_ + shift}, free, fits});
    }

    const PlacementSearch& search_;
    Eigen::Quaterniond rotation_;
    Eigen::Vector3d centre_;
    std::vector<Eigen::Vector3d> normals_;
    std::vector<std::vector<Offset>> offsets_;
    int& mostFits_;
};

/// True where pairs would fix a pose without any one of them: to centimetres, and to fractions of a degree.
bool fixRedundantly(std::span<const MatchedPlanes> pairs, const Pose& pose)
{
    constexpr double kShift = 0.1;  // standard deviation [m]
    constexpr double kTurn = degrees(0.5);
    std::vector<Matrix6d> each;
    Matrix6d all = Matrix6d::Zero();
    for (const MatchedPlanes& pair : pairs) {
        const UncertainPlane seen = inMap(pair.seen, {pose.rotation, Eigen::Vector3d::Zero()});
        const UncertainPlane known = seenFrom(pair.known, pose.translation);
        const Matrix3x6d jacobian = poseJacobian(seen, {});
        each.emplace_back(jacobian.transpose() * (seen.covariance + covarianceIn(seen, known)).llt().solve(jacobian));
        all += each.back();
    }
    return !pairs.empty() && std::ranges::all_of(each, [&](const Matrix6d& one) {
        const PoseStrength strength = poseStrength(all - one);
        return strength.fixesAll() && *strength.shift.weakestSigma < kShift && *strength.turn.weakestSigma < kTurn;
    });
}

/// The pairs that fit together at a place tried, and the pose that they give.
std::optional<Placement> refine(const Trial& trial, std::span<const WeighedPlane> seen,
                                std::span<const WeighedPlane> known, const PlanesMeet& meet)
{
    Matrix6d spread = Matrix6d::Identity() * square(kTurnSpread);
    spread.bottomRightCorner<3, 3>() = Eigen::Matrix3d::Identity() * square(0.5 * kSameDistance) + trial.free;
    std::vector<MatchChoices> choices(seen.size());
    const double least = std::cos(kSameDirection);
    for (std::size_t i = 0; i < seen.size(); ++i) {
        const UncertainPlane turned = inMap(seen[i].parameters, {trial.pose.rotation, Eigen::Vector3d::Zero()});
        choices[i].jacobian = poseJacobian(turned, {});
        for (std::size_t j = 0; j < known.size(); ++j) {
            if (turned.normal.dot(known[j].parameters.normal) < least)
                continue;
            const UncertainPlane there = seenFrom(known[j].parameters, trial.pose.translation);
            const double loose = std::sqrt(turned.normal.dot(trial.free * turned.normal));
            if (std::abs(there.distance - turned.distance) > 2.0 * kSameDistance + 3.0 * loose ||
                !meet(i, j, trial.pose))
                continue;
            choices[i].candidates.push_back(
                {j, difference(turned, there), turned.covariance + covarianceIn(turned, there)});
        }
    }
    const JointMatch match = matchJointly(choices, spread);
    Placement placement;
    std::vector<MatchedPlanes> pairs;
    for (std::size_t i = 0; i < seen.size(); ++i) {
        if (!match.chosen[i])
            continue;
        const std::size_t j = choices[i].candidates[*match.chosen[i]].known;
        placement.pairs.emplace_back(i, j);
        pairs.push_back({seen[i].parameters, known[j].parameters});
    }
    // Wide enough to leave the pose to the planes where these fix it.
    Matrix6d wide = 100.0 * spread;
    const auto registered = registerPlanes(pairs, PosePrior{trial.pose, wide});
    if (!registered)
        return std::nullopt;
    placement.pose = registered->pose;
    placement.covariance = registered->covariance;
    placement.fixed = fixRedundantly(pairs, placement.pose);
    return placement;
}

}  // namespace

bool isSamePlace(const Pose& a, const Pose& b)
{
    return turnBetween(a.rotation, b.rotation) < kSameDirection && (a.translation - b.translation).norm() < kSamePlace;
}

std::vector<Placement> placeByPlanes(std::span<const WeighedPlane> seen, std::span<const WeighedPlane> known,
                                     const PlacementSearch& search, const PlanesMeet& meet)
{
    const std::vector<std::size_t> largest = bySize(seen, 10);
    std::vector<Trial> trials;
    int mostFits = 0;
    for (const Eigen::Quaterniond& rotation : rotationsOf(seen, known, search.tilt))
        ShiftSearch(seen, known, rotation, search, mostFits).run(largest, trials);
    std::ranges::stable_sort(trials, std::ranges::greater{}, &Trial::fits);

    std::vector<Placement> placements;
    std::vector<Pose> refined;
    for (const Trial& trial : trials) {
        const auto isKnown = [&](const Pose& pose) { return isSamePlace(pose, trial.pose); };
        if (refined.size() == kMostRefined)
            break;
        if (std::ranges::any_of(refined, isKnown))
            continue;
        refined.push_back(trial.pose);
        auto placement = refine(trial, seen, known, meet);
        // What the planes of a trial leave open, others may fix out of reach.
        const bool isInReach =
            placement && (!search.about || (placement->pose.translation - search.about->translation).norm() <=
                                               search.reach + kSamePlace);
        const bool isNew = isInReach && std::ranges::none_of(placements, [&](const Placement& other) {
                               return isSamePlace(other.pose, placement->pose);
                           });
        if (isNew)
            placements.push_back(std::move(*placement));
    }
    std::ranges::stable_sort(placements, std::ranges::greater{},
                             [](const Placement& placement) { return placement.pairs.size(); });
    return placements;
}

}  // namespace planewright
