// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/evaluation/label_overlap.h"

#include <algorithm>
#include <string>
#include <unordered_map>
#include <utility>

namespace planewright {

namespace {

/// How many beams have label a in A and b in B.
struct PairCount {
    int a = 0;
    int b = 0;
    std::int64_t beams = 0;
};

Result<void> checkShapes(const LabelGrid& a, const LabelGrid& b)
{
    const std::string advice = "; both labellings must be of the same recording";
    if (a.size() != b.size())
        return fail(ErrorCode::Unreadable,
                    std::to_string(a.size()) + " lines against " + std::to_string(b.size()) + advice);
    for (std::size_t row = 0; row < a.size(); ++row) {
        if (a[row].size() != b[row].size())
            return fail(ErrorCode::Unreadable, "line " + std::to_string(row + 1) + ": " +
                                                   std::to_string(a[row].size()) + " labels against " +
                                                   std::to_string(b[row].size()) + advice);
    }
    return {};
}

/// The sparse contingency table of two grids of one shape, in order of a, then b.
std::vector<PairCount> countPairs(const LabelGrid& a, const LabelGrid& b)
{
    std::unordered_map<std::uint64_t, PairCount> counts;
    PairCount* current = nullptr;  // neighbouring beams mostly have the same labels
    for (std::size_t row = 0; row < a.size(); ++row) {
        for (std::size_t beam = 0; beam < a[row].size(); ++beam) {
            const int labelA = a[row][beam];
            const int labelB = b[row][beam];
            if (current == nullptr || current->a != labelA || current->b != labelB) {
                const std::uint64_t key =
                    (std::uint64_t{static_cast<std::uint32_t>(labelA)} << 32) | static_cast<std::uint32_t>(labelB);
                current = &counts.try_emplace(key, PairCount{labelA, labelB, 0}).first->second;
            }
            ++current->beams;
        }
    }
    std::vector<PairCount> pairs;
    pairs.reserve(counts.size());
    for (const auto& [key, count] : counts)
        pairs.push_back(count);
    std::sort(pairs.begin(), pairs.end(), [](const PairCount& x, const PairCount& y) {
        return std::pair{x.a, x.b} < std::pair{y.a, y.b};
    });
    return pairs;
}

/// The regions of ids that may repeat, in order of id.
std::vector<LabelOverlap::Region> regionsOf(std::vector<int> ids)
{
    std::sort(ids.begin(), ids.end());
    ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
    std::vector<LabelOverlap::Region> regions;
    regions.reserve(ids.size());
    for (const int id : ids)
        regions.push_back({id, 0, 0});
    return regions;
}

std::size_t placeOf(const std::vector<LabelOverlap::Region>& regions, int id)
{
    const auto found =
        std::lower_bound(regions.begin(), regions.end(), id,
                         [](const LabelOverlap::Region& region, int wanted) { return region.id < wanted; });
    return static_cast<std::size_t>(found - regions.begin());
}

}  // namespace

Result<LabelOverlap> overlapOf(const LabelGrid& a, const LabelGrid& b)
{
    if (Result<void> shapes = checkShapes(a, b); !shapes)
        return tl::unexpected{shapes.error()};
    const std::vector<PairCount> pairs = countPairs(a, b);

    std::vector<int> idsA;
    std::vector<int> idsB;
    for (const PairCount& pair : pairs) {
        if (pair.a >= 0)
            idsA.push_back(pair.a);
        if (pair.b >= 0)
            idsB.push_back(pair.b);
    }
    LabelOverlap overlap{regionsOf(std::move(idsA)), regionsOf(std::move(idsB)), {}};
    for (const PairCount& pair : pairs) {
        if (pair.b >= 0)
            overlap.regionsB[placeOf(overlap.regionsB, pair.b)].returns += pair.beams;
        if (pair.a < 0)
            continue;
        LabelOverlap::Region& region = overlap.regionsA[placeOf(overlap.regionsA, pair.a)];
        (pair.b == kNotAPlane ? region.notPlane : region.returns) += pair.beams;
        if (pair.b >= 0)
            overlap.common.push_back(
                {placeOf(overlap.regionsA, pair.a), placeOf(overlap.regionsB, pair.b), pair.beams});
    }
    return overlap;
}

}  // namespace planewright
