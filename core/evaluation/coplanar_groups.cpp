// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/evaluation/coplanar_groups.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace planewright {

bool areCoplanar(const ComparedPlane& a, const ComparedPlane& b)
{
    if (differenceOf(a, b).angle > kCoplanarAngle)
        return false;
    const double cosine = a.normal.dot(b.normal);
    return std::abs(cosine * b.distance - a.distance) <= kCoplanarDistance &&
           std::abs(cosine * a.distance - b.distance) <= kCoplanarDistance;
}

std::vector<std::size_t> coplanarGroups(std::span<const ComparedPlane> planes)
{
    std::vector<std::size_t> first(planes.size());
    std::iota(first.begin(), first.end(), std::size_t{0});
    const auto root = [&](std::size_t place) {
        while (first[place] != place)
            place = first[place] = first[first[place]];
        return place;
    };
    for (std::size_t i = 0; i < planes.size(); ++i) {
        for (std::size_t j = i + 1; j < planes.size(); ++j) {
            if (!areCoplanar(planes[i], planes[j]))
                continue;
            const auto [low, high] = std::minmax({root(i), root(j)});
            first[high] = low;
        }
    }
    for (std::size_t i = 0; i < planes.size(); ++i)
        first[i] = root(i);
    return first;
}

}  // namespace planewright
