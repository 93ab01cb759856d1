// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/mapping/match_jointly.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Cholesky>

namespace planewright {

namespace {

using Choice = std::vector<std::optional<std::size_t>>;

/// What is known of the pose's error after some pairs (Kalman 1960).
struct PoseBelief {
    Vector6d error = Vector6d::Zero();
    Matrix6d covariance;

    double chiSquare(const Matrix3x6d& jacobian, const MatchCandidate& candidate) const
    {
        const Eigen::Vector3d miss = candidate.apart - jacobian * error;
        const Eigen::Matrix3d spread = jacobian * covariance * jacobian.transpose() + candidate.noise;
        return miss.dot(spread.llt().solve(miss));
    }

    void add(const Matrix3x6d& jacobian, const MatchCandidate& candidate)
    {
        const Eigen::Vector3d miss = candidate.apart - jacobian * error;
        const Matrix3x6d shared = jacobian * covariance;
        const Eigen::Matrix3d spread = shared * jacobian.transpose() + candidate.noise;
        const Eigen::Matrix<double, 6, 3> gain = spread.llt().solve(shared).transpose();
        error += gain * miss;
        covariance -= gain * shared;
        covariance = (0.5 * (covariance + covariance.transpose())).eval();
    }
};

/// A candidate that the pose so far allows.
struct LiveCandidate {
    std::size_t plane;
    std::size_t candidate;
    double chiSquare;
};

class JointSearch {
public:
    JointSearch(std::span<const MatchChoices> planes, const MatchLimits& limits) : planes_(planes), limits_(limits) {}

    JointMatch run(const Matrix6d& poseCovariance)
    {
        std::vector<LiveCandidate> all;
        for (std::size_t i = 0; i < planes_.size(); ++i) {
            for (std::size_t c = 0; c < planes_[i].candidates.size(); ++c)
                all.push_back({i, c, 0.0});
        }
        const PoseBelief start{Vector6d::Zero(), poseCovariance};
        best_.chosen.resize(planes_.size());
        best_.covariance = poseCovariance;
        descend(start, stillLive(all, start), {Choice(planes_.size()), 0, 0, 0.0});
        findRivals();
        measureLooseness(poseCovariance);
        best_.cutShort = nodes_ >= limits_.mostNodes;
        return std::move(best_);
    }

private:
    /// What has been chosen.
    struct Set {
        Choice chosen;
        int pairs = 0;    ///< planes of the map that are in it
        int choices = 0;  ///< planes of the stop: several may be one of the map
        double chiSquare = 0.0;
    };

    std::vector<LiveCandidate> stillLive(const std::vector<LiveCandidate>& before, const PoseBelief& belief) const
    {
        std::vector<LiveCandidate> live;
        live.reserve(before.size());
        for (LiveCandidate each : before) {
            const MatchChoices& plane = planes_[each.plane];
            each.chiSquare = belief.chiSquare(plane.jacobian, plane.candidates[each.candidate]);
            if (each.chiSquare < limits_.gate)
                live.push_back(each);
        }
        return live;
    }

    /// Where the candidates of the plane with the fewest begin, and how many planes there are. They lie side by side.
    static std::pair<std::size_t, int> nextPlane(const std::vector<LiveCandidate>& live)
    {
        std::size_t chosen = 0;
        std::size_t fewest = live.size() + 1;
        int planes = 0;
        for (std::size_t begin = 0; begin < live.size();) {
            std::size_t end = begin;
            while (end < live.size() && live[end].plane == live[begin].plane)
                ++end;
            if (end - begin < fewest) {
                fewest = end - begin;
                chosen = begin;
            }
            ++planes;
            begin = end;
        }
        return {chosen, planes};
    }

    void descend(const PoseBelief& belief, std::vector<LiveCandidate> live, const Set& set)
    {
        if (nodes_ >= limits_.mostNodes)
            return;
        ++nodes_;
        const auto [begin, planes] = nextPlane(live);
        if (set.pairs + planes < best_.pairs ||
            (set.pairs + planes == best_.pairs && set.chiSquare > best_.chiSquare + limits_.rivalMargin))
            return;
        if (live.empty()) {
            keep(belief, set);
            return;
        }
        const std::size_t plane = live[begin].plane;
        const auto mine =
            std::ranges::partition_point(live.begin() + static_cast<std::ptrdiff_t>(begin), live.end(),
                                         [plane](const LiveCandidate& each) { return each.plane == plane; });
        std::vector<LiveCandidate> options(live.begin() + static_cast<std::ptrdiff_t>(begin), mine);
        live.erase(live.begin() + static_cast<std::ptrdiff_t>(begin), mine);
        std::ranges::stable_sort(options, {}, &LiveCandidate::chiSquare);
        for (const LiveCandidate& option : options) {
            Set with = set;
            with.chiSquare += option.chiSquare;
            ++with.choices;
            if (with.chiSquare > chiSquareLimit(3 * with.choices) || isOfAnother(plane, option.candidate, set.chosen))
                continue;
            const MatchChoices& choices = planes_[plane];
            with.pairs += isChosen(choices.candidates[option.candidate].known, set.chosen) ? 0 : 1;
            with.chosen[plane] = option.candidate;
            PoseBelief next = belief;
            next.add(choices.jacobian, choices.candidates[option.candidate]);
            descend(next, stillLive(live, next), with);
        }
        descend(belief, std::move(live), set);
    }

    bool isChosen(std::size_t known, const Choice& chosen) const
    {
        for (std::size_t i = 0; i < chosen.size(); ++i) {
            if (chosen[i] && planes_[i].candidates[*chosen[i]].known == known)
                return true;
        }
        return false;
    }

    /// True where a candidate has been chosen for a plane of the stop that is surely not the same.
    bool isOfAnother(std::size_t plane, std::size_t candidate, const Choice& chosen) const
    {
        const std::size_t known = planes_[plane].candidates[candidate].known;
        return std::ranges::any_of(planes_[plane].others, [&](std::size_t other) {
            return chosen[other] && planes_[other].candidates[*chosen[other]].known == known;
        });
    }

    void keep(const PoseBelief& belief, const Set& set)
    {
        if (set.pairs > best_.pairs)
            leaves_.clear();
        leaves_.push_back(set);
        if (set.pairs > best_.pairs || (set.pairs == best_.pairs && isBetter(set))) {
            best_.chosen = set.chosen;
            best_.pairs = set.pairs;
            best_.chiSquare = set.chiSquare;
            best_.error = belief.error;
            best_.covariance = belief.covariance;
            choices_ = set.choices;
        }
    }

    /// Of as many planes of the map: χ² less what is expected of it.
    bool isBetter(const Set& set) const { return set.chiSquare - 3.0 * set.choices < best_.chiSquare - 3.0 * choices_; }

    /// What other sets as good as the best choose, and what alone would fit in the place of a choice.
    void findRivals()
    {
        best_.rivals.resize(planes_.size());
        best_.isContested.resize(planes_.size());
        const PoseBelief belief{best_.error, best_.covariance};
        for (std::size_t i = 0; i < planes_.size(); ++i) {
            if (!best_.chosen[i])
                continue;
            const auto& candidates = planes_[i].candidates;
            best_.isContested[i] = std::ranges::any_of(leaves_, [&](const Set& leaf) {
                return leaf.chiSquare < best_.chiSquare + limits_.rivalMargin &&
                       isOfAnother(i, *best_.chosen[i], leaf.chosen);
            });
            const double own = belief.chiSquare(planes_[i].jacobian, candidates[*best_.chosen[i]]);
            for (std::size_t c = 0; c < candidates.size(); ++c) {
                if (c == *best_.chosen[i] || isOfAnother(i, c, best_.chosen))
                    continue;
                const double other = belief.chiSquare(planes_[i].jacobian, candidates[c]);
                const bool fitsAlone = other < limits_.gate && other < own + limits_.rivalMargin;
                const bool fitsInAnother = std::ranges::any_of(leaves_, [&](const Set& leaf) {
                    return leaf.chosen[i] == c && leaf.chiSquare < best_.chiSquare + limits_.rivalMargin;
                });
                if (fitsAlone || fitsInAnother)
                    best_.rivals[i].push_back(c);
            }
        }
    }

    void measureLooseness(const Matrix6d& poseCovariance)
    {
        const auto informationOf = [&](std::size_t i) {
            const Matrix3x6d& jacobian = planes_[i].jacobian;
            return Matrix6d(jacobian.transpose() * planes_[i].candidates[*best_.chosen[i]].noise.llt().solve(jacobian));
        };
        Matrix6d all = poseCovariance.llt().solve(Matrix6d::Identity());
        for (std::size_t i = 0; i < planes_.size(); ++i) {
            if (best_.chosen[i])
                all += informationOf(i);
        }
        best_.looseness.resize(planes_.size());
        for (std::size_t i = 0; i < planes_.size(); ++i) {
            if (!best_.chosen[i])
                continue;
            const Eigen::Matrix<double, 1, 6> byPose = planes_[i].jacobian.row(2);
            const Vector6d spread = (all - informationOf(i)).llt().solve(byPose.transpose());
            best_.looseness[i] = std::sqrt(byPose.dot(spread) + planes_[i].candidates[*best_.chosen[i]].noise(2, 2));
        }
    }

    std::span<const MatchChoices> planes_;
    MatchLimits limits_;
    JointMatch best_;
    std::vector<Set> leaves_;  ///< of as many pairs as the best
    int choices_ = 0;          ///< of the best
    int nodes_ = 0;
};

}  // namespace

JointMatch matchJointly(std::span<const MatchChoices> planes, const Matrix6d& poseCovariance, const MatchLimits& limits)
{
    return JointSearch(planes, limits).run(poseCovariance);
}

}  // namespace planewright
