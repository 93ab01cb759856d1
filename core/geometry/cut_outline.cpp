// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/geometry/cut_outline.h"

#include <algorithm>

namespace planewright {

namespace {

/// Planes that are nearer to level than this sine of their slope meet no height along a line.
constexpr double kSameLevel = 1e-6;
/// Shorter pieces [m] are where a corner touches the height.
constexpr double kShortest = 1e-6;

/// Adds the places where a ring crosses the height. A corner at the height counts as above it, so that the ring comes
/// up as often as it goes down.
void addCrossings(const std::vector<Eigen::Vector3d>& ring, double height, std::vector<Eigen::Vector2d>& crossings)
{
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const Eigen::Vector3d& a = ring[i];
        const Eigen::Vector3d& b = ring[(i + 1) % ring.size()];
        if ((a.z() < height) == (b.z() < height))
            continue;
        const double share = (height - a.z()) / (b.z() - a.z());
        crossings.emplace_back((a + share * (b - a)).head<2>());
    }
}

}  // namespace

std::vector<PlanLine> cutAtHeight(const Outline& outline, const Eigen::Vector3d& normal, double height)
{
    const Eigen::Vector2d along{-normal.y(), normal.x()};
    std::vector<PlanLine> lines;
    if (along.norm() < kSameLevel)
        return lines;
    for (const Outline::Polygon& part : outline.parts) {
        std::vector<Eigen::Vector2d> crossings;
        addCrossings(part.ring, height, crossings);
        for (const auto& hole : part.holes)
            addCrossings(hole, height, crossings);
        std::sort(crossings.begin(), crossings.end(),
                  [&](const Eigen::Vector2d& a, const Eigen::Vector2d& b) { return along.dot(a) < along.dot(b); });
        for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
            if ((crossings[i + 1] - crossings[i]).norm() > kShortest)
                lines.push_back({crossings[i], crossings[i + 1]});
        }
    }
    return lines;
}

}  // namespace planewright
