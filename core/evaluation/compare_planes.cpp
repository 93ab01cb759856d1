// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/evaluation/compare_planes.h"

#include <algorithm>
#include <string>
#include <tuple>

namespace planewright {

namespace {

constexpr std::size_t kMaxPairs = std::size_t{1} << 24;

/// Two planes within the limits, by their places.
struct Pair {
    PlaneDifference difference;
    std::size_t a = 0;
    std::size_t b = 0;
};

Result<std::vector<Pair>> pairsWithin(std::span<const ComparedPlane> a, std::span<const ComparedPlane> b,
                                      const PlaneMatchLimits& limits)
{
    std::vector<Pair> pairs;
    for (std::size_t i = 0; i < a.size(); ++i) {
        for (std::size_t j = 0; j < b.size(); ++j) {
            const PlaneDifference difference = differenceOf(a[i], b[j]);
            if (difference.angle > limits.angle || difference.distance > limits.distance)
                continue;
            if (pairs.size() == kMaxPairs)
                return fail(ErrorCode::Usage, "more than " + std::to_string(kMaxPairs) +
                                                  " pairs of planes lie within the limits; give a smaller angle or "
                                                  "distance");
            pairs.push_back({difference, i, j});
        }
    }
    return pairs;
}

}  // namespace

Result<PlaneComparison> comparePlanes(std::span<const ComparedPlane> a, std::span<const ComparedPlane> b,
                                      const PlaneMatchLimits& limits)
{
    if (std::max(a.size(), b.size()) > kMaxComparedPlanes)
        return fail(ErrorCode::Usage, "no more than " + std::to_string(kMaxComparedPlanes) +
                                          " planes can be compared, these are " +
                                          std::to_string(std::max(a.size(), b.size())));
    Result<std::vector<Pair>> pairs = pairsWithin(a, b, limits);
    if (!pairs)
        return tl::unexpected{pairs.error()};
    std::sort(pairs->begin(), pairs->end(), [](const Pair& x, const Pair& y) {
        return std::tuple{x.difference.angle, x.difference.distance, x.a, x.b} <
               std::tuple{y.difference.angle, y.difference.distance, y.a, y.b};
    });

    std::vector<bool> usedA(a.size());
    std::vector<const Pair*> pairOfB(b.size());
    for (const Pair& pair : *pairs) {
        if (usedA[pair.a] || pairOfB[pair.b] != nullptr)
            continue;
        usedA[pair.a] = true;
        pairOfB[pair.b] = &pair;
    }

    PlaneComparison comparison;
    std::vector<PlaneDifference> differences;
    for (std::size_t j = 0; j < b.size(); ++j) {
        if (pairOfB[j] == nullptr) {
            comparison.unmatchedB.push_back(b[j].id);
            continue;
        }
        comparison.matches.push_back({a[pairOfB[j]->a].id, b[j].id, pairOfB[j]->difference});
        differences.push_back(pairOfB[j]->difference);
    }
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (!usedA[i])
            comparison.unmatchedA.push_back(a[i].id);
    }
    comparison.errors = summarise(differences);
    return comparison;
}

}  // namespace planewright
