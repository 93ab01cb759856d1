// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/evaluation/label_groups.h"

#include <map>
#include <utility>

#include "core/evaluation/coplanar_groups.h"

namespace planewright {

LabelGroups groupRegions(const LabelOverlap& overlap, std::span<const ComparedPlane> planesB, std::int64_t minReturns)
{
    LabelGroups result;
    const std::vector<std::size_t> first = coplanarGroups(planesB);
    result.groupOf.resize(first.size());
    for (std::size_t place = 0; place < first.size(); ++place) {
        if (first[place] == place) {
            result.groupOf[place] = result.groups.size();
            result.groups.emplace_back();
        } else {
            result.groupOf[place] = result.groupOf[first[place]];
        }
        LabelGroups::Group& group = result.groups[result.groupOf[place]];
        group.ids.push_back(overlap.regionsB[place].id);
        group.returns += overlap.regionsB[place].returns;
    }
    for (LabelGroups::Group& group : result.groups)
        group.counts = group.returns >= minReturns;

    std::map<std::pair<std::size_t, std::size_t>, std::int64_t> shared;
    for (const LabelOverlap::Common& common : overlap.common)
        shared[{common.a, result.groupOf[common.b]}] += common.returns;
    for (const auto& [pair, returns] : shared)
        result.shared.push_back({pair.first, pair.second, returns});
    return result;
}

}  // namespace planewright
