// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/planes/plane_search.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string_view>
#include <utility>

#include "core/planes/growing_plane.h"
#include "core/planes/neighbourhood.h"
#include "core/planes/plane_shape.h"
#include "core/planes/segment_run.h"

namespace planewright {

namespace {

/// Rounds of collecting support and refining; the support of a short triple grows as its plane settles.
constexpr int kSupportRounds = 5;

constexpr std::string_view kContradictions = "contradictions";
constexpr std::string_view kContested = "contested";

bool allPass(const std::vector<Test>& tests)
{
    return std::all_of(tests.begin(), tests.end(), [](const Test& test) { return test.pass(); });
}

/// True where a plane has all that it takes, but what is around it speaks against it.
bool onlyContested(const std::vector<Test>& tests)
{
    return std::all_of(tests.begin(), tests.end(), [](const Test& test) {
        return test.pass() || test.name == kContested || test.name == kContradictions;
    });
}

struct Hypothesis {
    double cost = 0.0;
    std::size_t seed = 0;
    Eigen::Vector3d normal;
    double distance = 0.0;
};

/// The candidates as contiguous arrays, and the planes they suggest.
class Search {
public:
    Search(const std::vector<Candidate>& candidates, const SegmentTable& table, const PlaneParameters& parameters)
        : candidates_(candidates), table_(table), parameters_(parameters)
    {
        segments_.reserve(candidates.size());
        midpoints_.reserve(candidates.size());
        for (const Candidate& candidate : candidates) {
            segments_.push_back(&table[candidate.segment]);
            midpoints_.push_back(segments_.back()->midpoint());
        }
    }

    /// The hypotheses of the seeds, the cheapest first.
    std::vector<Hypothesis> hypotheses() const
    {
        std::vector<Hypothesis> all;
        for (std::size_t seed = 0; seed < candidates_.size(); ++seed) {
            if (!candidates_[seed].seed)
                continue;
            if (auto hypothesis = hypothesisOf(seed))
                all.push_back(*hypothesis);
        }
        return byCost(std::move(all));
    }

    /// The hypotheses of the runs around some candidates, the cheapest first.
    std::vector<Hypothesis> runHypotheses(const std::vector<std::size_t>& around) const
    {
        std::vector<Hypothesis> all;
        for (const std::size_t seed : around) {
            if (const auto run = runAround(candidates_[seed].segment, table_, parameters_))
                all.push_back({costOf(run->normal, run->distance), seed, run->normal, run->distance});
        }
        return byCost(std::move(all));
    }

    /// Refines a hypothesis on its support until the support stays the same.
    FoundPlane grow(const Hypothesis& hypothesis, std::vector<std::size_t>& support) const
    {
        FoundPlane found;
        found.fit.normal = hypothesis.normal;
        found.fit.distance = hypothesis.distance;
        for (int round = 0; round < kSupportRounds; ++round) {
            std::vector<std::size_t> now =
                connectedTo(hypothesis.seed, supportOf(found.fit.normal, found.fit.distance));
            if (now == support || now.size() < 3)
                break;
            support = std::move(now);
            found.members.clear();
            for (const std::size_t i : support)
                found.members.push_back(candidates_[i].segment);
            found.fit = refinePlane(found.fit, endPointsOf(found.members, table_), parameters_);
        }
        found.tests = availability(found, support);
        return found;
    }

private:
    static std::vector<Hypothesis> byCost(std::vector<Hypothesis> all)
    {
        std::stable_sort(all.begin(), all.end(),
                         [](const Hypothesis& a, const Hypothesis& b) { return a.cost < b.cost; });
        return all;
    }

    /// The two nearest candidates, by midpoint, that are of slices other than the seed's and each other's, and far
    /// enough from the seed's line for its noise: neighbours a few millimetres apart would give a plane of any
    /// direction.
    std::optional<std::array<std::size_t, 3>> tripleOf(std::size_t seed) const
    {
        constexpr double kFar = std::numeric_limits<double>::infinity();
        const LineSegment& from = *segments_[seed];
        const double variance = 0.5 * (from.startCovariance.trace() + from.endCovariance.trace());
        const double baseline = parameters_.baselineSigmas * parameters_.baselineSigmas * variance;
        std::size_t nearest = 0;
        std::size_t second = 0;
        double nearestDistance = kFar;
        double secondDistance = kFar;
        for (std::size_t i = 0; i < segments_.size(); ++i) {
            const int step = segments_[i]->id.step;
            if (step == from.id.step)
                continue;
            const Eigen::Vector3d away = midpoints_[i] - midpoints_[seed];
            const double distance = away.squaredNorm();
            if (distance >= secondDistance)
                continue;
            const double along = away.dot(from.direction);
            if (distance - along * along < baseline)
                continue;
            if (distance < nearestDistance) {
                if (nearestDistance < kFar && segments_[nearest]->id.step != step) {
                    second = nearest;
                    secondDistance = nearestDistance;
                }
                nearest = i;
                nearestDistance = distance;
            } else if (segments_[nearest]->id.step != step) {
                second = i;
                secondDistance = distance;
            }
        }
        if (secondDistance == kFar)
            return std::nullopt;
        return std::array{seed, nearest, second};
    }

    std::optional<Hypothesis> hypothesisOf(std::size_t seed) const
    {
        const auto triple = tripleOf(seed);
        if (!triple)
            return std::nullopt;
        WeightedSums sums;
        for (const std::size_t i : *triple) {
            sums.add(segments_[i]->start, 1.0);
            sums.add(segments_[i]->end, 1.0);
        }
        const PlaneFit fit = fitPlane(sums, Eigen::Vector3d::UnitZ());
        for (const std::size_t i : *triple) {
            if (!supports(*segments_[i], fit.normal, fit.distance))
                return std::nullopt;
        }
        return Hypothesis{costOf(fit.normal, fit.distance), seed, fit.normal, fit.distance};
    }

    /// Squared distance of an end point and T² of Eq. (14), which far points with much noise get more of.
    struct Deviation {
        double squared = 0.0;
        double limit = 0.0;

        bool inside() const { return squared < limit; }
    };
    Deviation deviationOf(const Eigen::Vector3d& point, const Eigen::Matrix3d& covariance,
                          const Eigen::Vector3d& normal, double distance) const
    {
        const double residual = normal.dot(point) - distance;
        const double fixed = parameters_.inlierDistance * parameters_.inlierDistance;
        const double squared = residual * residual;
        const double sigmas = parameters_.inlierSigmas * parameters_.inlierSigmas;
        return {squared, std::max(fixed, sigmas * normal.dot(covariance * normal))};
    }

    /// Eq. (14) over both end points of all candidates, in units of T².
    double costOf(const Eigen::Vector3d& normal, double distance) const
    {
        double cost = 0.0;
        for (const LineSegment* segment : segments_) {
            const Deviation start = deviationOf(segment->start, segment->startCovariance, normal, distance);
            const Deviation end = deviationOf(segment->end, segment->endCovariance, normal, distance);
            cost +=
                (start.inside() ? start.squared / start.limit : 1.0) + (end.inside() ? end.squared / end.limit : 1.0);
        }
        return cost;
    }

    bool supports(const LineSegment& segment, const Eigen::Vector3d& normal, double distance) const
    {
        return deviationOf(segment.start, segment.startCovariance, normal, distance).inside() &&
               deviationOf(segment.end, segment.endCovariance, normal, distance).inside();
    }

    std::vector<std::size_t> supportOf(const Eigen::Vector3d& normal, double distance) const
    {
        std::vector<std::size_t> support;
        for (std::size_t i = 0; i < segments_.size(); ++i) {
            if (supports(*segments_[i], normal, distance))
                support.push_back(i);
        }
        return support;
    }

    /// The part of a support that hangs together with the seed, from neighbour to neighbour: segments far apart that
    /// lie in one plane by chance support nothing.
    std::vector<std::size_t> connectedTo(std::size_t seed, const std::vector<std::size_t>& support) const
    {
        std::vector<std::size_t> order = support;
        std::stable_sort(order.begin(), order.end(), [this](std::size_t a, std::size_t b) {
            return segments_[a]->id.step < segments_[b]->id.step;
        });
        std::vector<char> reached(order.size(), 0);
        std::vector<std::size_t> open;
        for (std::size_t i = 0; i < order.size(); ++i) {
            if (order[i] == seed) {
                reached[i] = 1;
                open.push_back(i);
            }
        }
        const auto visit = [&](std::size_t from, std::size_t to) {
            if (reached[to] == 0 && areNeighbours(*segments_[order[from]], *segments_[order[to]])) {
                reached[to] = 1;
                open.push_back(to);
            }
        };
        const auto stepOf = [&](std::size_t i) { return segments_[order[i]]->id.step; };
        while (!open.empty()) {
            const std::size_t here = open.back();
            open.pop_back();
            for (std::size_t i = here; i-- > 0 && stepOf(here) - stepOf(i) <= kNeighbourSlices;)
                visit(here, i);
            for (std::size_t i = here + 1; i < order.size() && stepOf(i) - stepOf(here) <= kNeighbourSlices; ++i)
                visit(here, i);
        }
        std::vector<std::size_t> connected;
        for (std::size_t i = 0; i < order.size(); ++i) {
            if (reached[i] != 0)
                connected.push_back(order[i]);
        }
        std::sort(connected.begin(), connected.end());
        return connected;
    }

    bool areNeighbours(const LineSegment& a, const LineSegment& b) const
    {
        return faceEachOther(a, b) || segmentDistance(a, b) <= parameters_.mergeGap;
    }

    /// Candidates that face the support but stand a little off the plane, as the steps of a stair do off the slope over
    /// their edges.
    int contradictions(const std::vector<std::size_t>& support, const PlaneFit& fit) const
    {
        std::vector<char> supporting(segments_.size(), 0);
        for (const std::size_t i : support)
            supporting[i] = 1;
        int count = 0;
        for (std::size_t i = 0; i < segments_.size(); ++i) {
            if (supporting[i] != 0 || !standsOff(*segments_[i], fit))
                continue;
            const bool faces = std::any_of(support.begin(), support.end(), [&](std::size_t j) {
                return std::abs(segments_[i]->id.step - segments_[j]->id.step) <= kNeighbourSlices &&
                       segments_[i]->firstBeam <= segments_[j]->lastBeam &&
                       segments_[j]->firstBeam <= segments_[i]->lastBeam;
            });
            count += faces ? 1 : 0;
        }
        return count;
    }

    bool standsOff(const LineSegment& segment, const PlaneFit& fit) const
    {
        const Deviation start = deviationOf(segment.start, segment.startCovariance, fit.normal, fit.distance);
        const Deviation end = deviationOf(segment.end, segment.endCovariance, fit.normal, fit.distance);
        constexpr double kNear = 16.0;  // four times the inlier distance, squared
        return (!start.inside() || !end.inside()) && start.squared < kNear * start.limit &&
               end.squared < kNear * end.limit;
    }

    std::vector<Test> availability(const FoundPlane& found, const std::vector<std::size_t>& support) const
    {
        int points = 0;
        std::vector<int> steps;
        for (const SegmentNumber number : found.members) {
            points += table_[number].points;
            steps.push_back(table_[number].id.step);
        }
        // Segments that were clustered again stand behind later ones.
        std::sort(steps.begin(), steps.end());
        const auto slices = std::unique(steps.begin(), steps.end()) - steps.begin();
        std::vector<Test> tests{
            {"segments", static_cast<double>(found.members.size()), Comparison::GreaterEqual,
             static_cast<double>(parameters_.minSegments)},
            {"slices", static_cast<double>(slices), Comparison::GreaterEqual,
             static_cast<double>(parameters_.minSlices)},
            {"points", static_cast<double>(points), Comparison::GreaterEqual,
             static_cast<double>(parameters_.minPoints)},
        };
        if (found.members.empty())
            return tests;
        const PlaneView view = viewOf(found.members, found.fit, table_);
        tests.push_back({"extent", shorterExtent(found.members, found.fit, table_), Comparison::GreaterEqual,
                         std::max(parameters_.minExtent,
                                  view.range * std::tan(parameters_.minExtentAngle) * (1.0 - 0.5 * view.incidence))});
        tests.push_back({"normal_sigma", std::sqrt(largestNormalVariance(covarianceOf(found.fit))),
                         Comparison::LessEqual, parameters_.maxNormalSigma});
        tests.push_back({"incidence", view.incidence, Comparison::GreaterEqual, std::sin(parameters_.minIncidence)});
        tests.push_back({kContradictions, static_cast<double>(contradictions(support, found.fit)),
                         Comparison::LessEqual, static_cast<double>(found.members.size())});
        tests.push_back({"fitting_error", found.fit.error, Comparison::LessEqual, parameters_.errorLimit});
        if (allPass(tests))
            tests.push_back({kContested,
                             contestedShare(found.members, found.fit.normal, found.fit.distance, table_, parameters_),
                             Comparison::LessEqual, parameters_.maxContested});
        return tests;
    }

    const std::vector<Candidate>& candidates_;
    const SegmentTable& table_;
    const PlaneParameters& parameters_;
    std::vector<const LineSegment*> segments_;
    std::vector<Eigen::Vector3d> midpoints_;
};

/// What was tried in vain.
struct Tried {
    std::vector<char> covered;
    std::vector<FailedHypothesis>* failures = nullptr;
};

/// Grows one hypothesis; none where its plane is not available.
std::optional<FoundPlane> availablePlane(const Search& search, const Hypothesis& hypothesis, SegmentNumber seed,
                                         std::vector<std::size_t>& support, bool& contested, Tried& tried)
{
    FoundPlane found = search.grow(hypothesis, support);
    if (allPass(found.tests))
        return found;
    contested = onlyContested(found.tests);
    tried.covered[hypothesis.seed] = 1;
    // What supports a contested plane may yet support those that contest it.
    if (!contested) {
        for (const std::size_t i : support)
            tried.covered[i] = 1;
    }
    if (tried.failures != nullptr)
        tried.failures->push_back({seed, std::move(found.tests)});
    return std::nullopt;
}

}  // namespace

std::optional<FoundPlane> findPlane(const std::vector<Candidate>& candidates, const SegmentTable& table,
                                    const PlaneParameters& parameters, std::vector<FailedHypothesis>* failures)
{
    const Search search(candidates, table, parameters);
    Tried tried{std::vector<char>(candidates.size(), 0), failures};
    Tried triedRuns = tried;
    for (const Hypothesis& hypothesis : search.hypotheses()) {
        if (tried.covered[hypothesis.seed] != 0)
            continue;
        std::vector<std::size_t> support;
        bool contested = false;
        if (auto found =
                availablePlane(search, hypothesis, candidates[hypothesis.seed].segment, support, contested, tried))
            return found;
        if (!contested)
            continue;
        for (const Hypothesis& run : search.runHypotheses(support)) {
            if (triedRuns.covered[run.seed] != 0)
                continue;
            std::vector<std::size_t> ofRun;
            if (auto found = availablePlane(search, run, candidates[run.seed].segment, ofRun, contested, triedRuns))
                return found;
        }
    }
    return std::nullopt;
}

}  // namespace planewright
