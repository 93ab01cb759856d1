// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/evaluation/compare_labels.h"

#include <algorithm>
#include <string>
#include <unordered_map>
#include <utility>

namespace planewright {

namespace {

using Region = LabelOverlap::Region;
using Common = LabelOverlap::Common;

/// The planes of the regions, in their order.
Result<std::vector<ComparedPlane>> planesOf(const std::vector<Region>& regions, std::span<const ComparedPlane> planes,
                                            const std::string& side)
{
    std::unordered_map<int, const ComparedPlane*> byId;
    for (const ComparedPlane& plane : planes)
        byId.emplace(plane.id, &plane);
    std::vector<ComparedPlane> found;
    for (const Region& region : regions) {
        const auto plane = byId.find(region.id);
        if (plane == byId.end())
            return fail(ErrorCode::Unreadable, "the labels of " + side + " name plane " + std::to_string(region.id) +
                                                   ", which its planes do not list; give planes and labels of the "
                                                   "same run");
        found.push_back(*plane->second);
    }
    return found;
}

/// The matching of regions with groups, one set of Hoover's after the other.
class Matching {
public:
    Matching(const LabelOverlap& overlap, LabelGroups groups, const LabelMatchSettings& settings)
        : overlap_(overlap),
          settings_(settings),
          groups_(std::move(groups.groups)),
          groupOf_(std::move(groups.groupOf)),
          shared_(std::move(groups.shared)),
          usedA_(overlap.regionsA.size()),
          usedB_(groups_.size())
    {
    }

    LabelComparison compare(const std::vector<ComparedPlane>& planesA, const std::vector<ComparedPlane>& planesB)
    {
        findCorrect(planesA, planesB);
        findOverSegmented();
        findUnderSegmented();
        collectRest();
        return std::move(comparison_);
    }

private:
    static double share(std::int64_t part, std::int64_t whole)
    {
        return static_cast<double>(part) / static_cast<double>(whole);
    }
    double shareOfA(const Common& pair) const { return share(pair.returns, overlap_.regionsA[pair.a].returns); }
    double shareOfB(const Common& pair) const { return share(pair.returns, groups_[pair.b].returns); }

    void findCorrect(const std::vector<ComparedPlane>& planesA, const std::vector<ComparedPlane>& planesB)
    {
        std::vector<const Common*> candidates;
        for (const Common& pair : shared_) {
            if (groups_[pair.b].counts && std::min(shareOfA(pair), shareOfB(pair)) >= settings_.overlap)
                candidates.push_back(&pair);
        }
        std::stable_sort(candidates.begin(), candidates.end(), [&](const Common* x, const Common* y) {
            return shareOfA(*x) + shareOfB(*x) > shareOfA(*y) + shareOfB(*y);
        });
        std::erase_if(candidates, [&](const Common* pair) {
            if (usedA_[pair->a] || usedB_[pair->b])
                return true;
            usedA_[pair->a] = usedB_[pair->b] = true;
            return false;
        });
        std::sort(candidates.begin(), candidates.end(), [](const Common* x, const Common* y) { return x->b < y->b; });
        std::vector<PlaneDifference> differences;
        for (const Common* pair : candidates) {
            comparison_.correct.push_back({overlap_.regionsA[pair->a].id, groups_[pair->b].ids, pair->returns});
            differences.push_back(differenceOf(planesA[pair->a], planesB[mostShared(*pair)]));
        }
        comparison_.errors = summarise(differences);
    }

    /// The plane of a pair's group that shares most returns with its region; the lowest id of equals.
    std::size_t mostShared(const Common& pair) const
    {
        const Common* best = nullptr;
        auto common = std::lower_bound(overlap_.common.begin(), overlap_.common.end(), pair.a,
                                       [](const Common& c, std::size_t a) { return c.a < a; });
        for (; common != overlap_.common.end() && common->a == pair.a; ++common) {
            if (groupOf_[common->b] == pair.b && (best == nullptr || common->returns > best->returns))
                best = &*common;
        }
        return best->b;
    }

    void findOverSegmented()
    {
        std::vector<std::vector<const Common*>> pieces(groups_.size());
        for (const Common& pair : shared_) {
            if (groups_[pair.b].counts && !usedB_[pair.b] && !usedA_[pair.a] && shareOfA(pair) >= settings_.overlap)
                pieces[pair.b].push_back(&pair);
        }
        for (std::size_t b = 0; b < groups_.size(); ++b) {
            std::erase_if(pieces[b], [&](const Common* pair) { return usedA_[pair->a]; });
            if (pieces[b].size() < 2 || share(returnsOf(pieces[b]), groups_[b].returns) < settings_.overlap)
                continue;
            OverSegmentation instance{groups_[b].ids, {}};
            for (const Common* pair : pieces[b]) {
                instance.a.push_back(overlap_.regionsA[pair->a].id);
                usedA_[pair->a] = true;
            }
            usedB_[b] = true;
            comparison_.overSegmented.push_back(std::move(instance));
        }
    }

    void findUnderSegmented()
    {
        std::vector<std::vector<const Common*>> parts(usedA_.size());
        for (const Common& pair : shared_) {
            if (groups_[pair.b].counts && !usedB_[pair.b] && !usedA_[pair.a] && shareOfB(pair) >= settings_.overlap)
                parts[pair.a].push_back(&pair);
        }
        for (std::size_t a = 0; a < parts.size(); ++a) {
            std::erase_if(parts[a], [&](const Common* pair) { return usedB_[pair->b]; });
            if (parts[a].size() < 2 || share(returnsOf(parts[a]), overlap_.regionsA[a].returns) < settings_.overlap)
                continue;
            UnderSegmentation instance{overlap_.regionsA[a].id, {}};
            for (const Common* pair : parts[a]) {
                instance.b.push_back(groups_[pair->b].ids);
                usedB_[pair->b] = true;
            }
            usedA_[a] = true;
            comparison_.underSegmented.push_back(std::move(instance));
        }
    }

    static std::int64_t returnsOf(const std::vector<const Common*>& pairs)
    {
        std::int64_t sum = 0;
        for (const Common* pair : pairs)
            sum += pair->returns;
        return sum;
    }

    void collectRest()
    {
        std::vector<std::int64_t> uncounted(usedA_.size());
        for (const Common& pair : shared_) {
            if (!groups_[pair.b].counts)
                uncounted[pair.a] += pair.returns;
        }
        for (std::size_t a = 0; a < usedA_.size(); ++a) {
            const Region& region = overlap_.regionsA[a];
            const bool ignored = !usedA_[a] && share(uncounted[a] + region.notPlane,
                                                     region.returns + region.notPlane) >= settings_.overlap;
            if (ignored)
                comparison_.ignored.push_back(region.id);
            else if (!usedA_[a])
                comparison_.noise.push_back(region.id);
            comparison_.regions += ignored ? 0 : 1;
        }
        for (std::size_t b = 0; b < groups_.size(); ++b) {
            comparison_.groups += groups_[b].counts ? 1 : 0;
            if (groups_[b].counts && !usedB_[b])
                comparison_.missed.push_back(groups_[b].ids);
        }
        rate();
    }

    void rate()
    {
        const auto correct = static_cast<std::int64_t>(comparison_.correct.size());
        const auto rateOf = [&](std::size_t all) {
            return all == 0 ? 1.0 : share(correct, static_cast<std::int64_t>(all));
        };
        comparison_.recall = rateOf(comparison_.groups);
        comparison_.precision = rateOf(comparison_.regions);
        const double sum = comparison_.recall + comparison_.precision;
        comparison_.f1 = sum > 0.0 ? 2.0 * comparison_.recall * comparison_.precision / sum : 0.0;
    }

    const LabelOverlap& overlap_;
    const LabelMatchSettings& settings_;
    std::vector<LabelGroups::Group> groups_;
    std::vector<std::size_t> groupOf_;  ///< group of each region of B
    std::vector<Common> shared_;        ///< as LabelOverlap::common, but b is a group
    std::vector<bool> usedA_;
    std::vector<bool> usedB_;
    LabelComparison comparison_;
};

}  // namespace

Result<LabelComparison> compareLabels(const LabelGrid& labelsA, const LabelGrid& labelsB,
                                      std::span<const ComparedPlane> planesA, std::span<const ComparedPlane> planesB,
                                      const LabelMatchSettings& settings)
{
    if (std::max(planesA.size(), planesB.size()) > kMaxComparedPlanes)
        return fail(ErrorCode::Usage, "no more than " + std::to_string(kMaxComparedPlanes) +
                                          " planes can be compared, these are " +
                                          std::to_string(std::max(planesA.size(), planesB.size())));
    const Result<LabelOverlap> overlap = overlapOf(labelsA, labelsB);
    if (!overlap)
        return tl::unexpected{overlap.error()};
    const Result<std::vector<ComparedPlane>> seenA = planesOf(overlap->regionsA, planesA, "A");
    if (!seenA)
        return tl::unexpected{seenA.error()};
    const Result<std::vector<ComparedPlane>> seenB = planesOf(overlap->regionsB, planesB, "B");
    if (!seenB)
        return tl::unexpected{seenB.error()};
    return Matching{*overlap, groupRegions(*overlap, *seenB, settings.minReturns), settings}.compare(*seenA, *seenB);
}

}  // namespace planewright
