// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/mapping/stop_index.h"

#include <algorithm>
#include <cmath>

namespace planewright {

StopIndex::Cell StopIndex::cellOf(const Eigen::Vector3d& place) const
{
    return {static_cast<int>(std::floor(place.x() / cell_)), static_cast<int>(std::floor(place.y() / cell_))};
}

void StopIndex::add(std::size_t stop, const Eigen::Vector3d& place)
{
    cells_[cellOf(place)].push_back({stop, place.head<2>()});
}

void StopIndex::move(std::size_t stop, const Eigen::Vector3d& from, const Eigen::Vector3d& to)
{
    std::erase_if(cells_[cellOf(from)], [stop](const Entry& entry) { return entry.stop == stop; });
    add(stop, to);
}

std::vector<std::size_t> StopIndex::nearest(const Eigen::Vector3d& place, std::size_t most, double range) const
{
    struct Found {
        double distance;
        std::size_t stop;
        auto operator<=>(const Found&) const = default;
    };
    std::vector<Found> found;
    const Cell middle = cellOf(place);
    const int rings = static_cast<int>(std::ceil(range / cell_));
    for (int ring = 0; ring <= rings; ++ring) {
        for (int x = -ring; x <= ring; ++x) {
            // The whole first and last column of the ring, else its two ends.
            const int step = std::abs(x) == ring ? 1 : std::max(1, 2 * ring);
            for (int y = -ring; y <= ring; y += step) {
                const auto cell = cells_.find({middle.first + x, middle.second + y});
                if (cell == cells_.end())
                    continue;
                for (const Entry& entry : cell->second) {
                    const double distance = (entry.place - place.head<2>()).norm();
                    if (distance <= range)
                        found.push_back({distance, entry.stop});
                }
            }
        }
        // Whatever lies in farther rings is farther than this.
        const auto isSure = [&](const Found& each) { return each.distance <= ring * cell_; };
        if (static_cast<std::size_t>(std::ranges::count_if(found, isSure)) >= most)
            break;
    }
    std::ranges::sort(found);
    std::vector<std::size_t> stops;
    for (const Found& each : found) {
        if (stops.size() == most)
            break;
        stops.push_back(each.stop);
    }
    return stops;
}

}  // namespace planewright
