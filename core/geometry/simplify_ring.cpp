// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/geometry/simplify_ring.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace planewright {
namespace {

double distanceToChord(const Eigen::Vector2d& point, const Eigen::Vector2d& from, const Eigen::Vector2d& to)
{
    const Eigen::Vector2d chord = to - from;
    const double squaredLength = chord.squaredNorm();
    const double along = squaredLength > 0.0 ? std::clamp(chord.dot(point - from) / squaredLength, 0.0, 1.0) : 0.0;
    return (point - from - along * chord).norm();
}

}  // namespace

PlanarRing simplifyRing(const PlanarRing& ring, double tolerance)
{
    const std::size_t n = ring.size();
    if (n < 4)
        return ring;
    const auto at = [&](std::size_t i) -> const Eigen::Vector2d& { return ring[i % n]; };
    const auto farthestFrom = [&](const Eigen::Vector2d& place) {
        std::size_t farthest = 0;
        for (std::size_t i = 1; i < n; ++i) {
            if ((ring[i] - place).squaredNorm() > (ring[farthest] - place).squaredNorm())
                farthest = i;
        }
        return farthest;
    };
    // Two corners for certain: the vertex farthest from any one, and the one farthest from that.
    const std::size_t first = farthestFrom(ring[0]);
    const std::size_t second = farthestFrom(ring[first]);
    const std::size_t between = second > first ? second : second + n;

    std::vector<char> kept(n, 0);
    kept[first] = kept[second] = 1;
    std::vector<std::pair<std::size_t, std::size_t>> open{{first, between}, {between, first + n}};
    while (!open.empty()) {
        const auto [from, to] = open.back();
        open.pop_back();
        std::size_t farthest = from;
        double distance = tolerance;
        for (std::size_t i = from + 1; i < to; ++i) {
            const double d = distanceToChord(at(i), at(from), at(to));
            if (d > distance) {
                distance = d;
                farthest = i;
            }
        }
        if (farthest == from)
            continue;
        kept[farthest % n] = 1;
        open.emplace_back(from, farthest);
        open.emplace_back(farthest, to);
    }

    PlanarRing simple;
    for (std::size_t i = 0; i < n; ++i) {
        if (kept[i] != 0)
            simple.push_back(ring[i]);
    }
    return simple;
}

}  // namespace planewright
