// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

// How a MapBuilder adjusts the map: some stops as one joins, or all of it.

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

#include "core/mapping/contradictions.h"
#include "core/mapping/fuse_planes.h"
#include "core/mapping/map_builder.h"
#include "core/mapping/map_covariances.h"
#include "core/mapping/unevenness.h"

namespace planewright {

namespace {

constexpr std::size_t kAdjustedWith = 2;  // stops beside the one that joins
constexpr int kFlatnessRounds = 4;
constexpr int kContradictionRounds = 3;
constexpr double kSameFlatness = 0.8;  // a flatness that is less by no more than this share is none to adjust by

}  // namespace

Result<MapAdjustment> MapBuilder::adjust()
{
    std::vector<Eigen::Vector3d> before;
    for (const MapStop& stop : map_.stops)
        before.push_back(stop.pose.translation);
    auto done = adjustAndDecide();
    for (std::size_t stop = 0; stop < before.size(); ++stop) {
        if (map_.stops[stop].isPlaced())
            index_.move(stop, before[stop], map_.stops[stop].pose.translation);
    }
    return done;
}

/// What was left open is decided between two adjustments.
Result<MapAdjustment> MapBuilder::adjustAndDecide()
{
    auto done = adjustWhole();
    if (!done)
        return done;
    const double costBefore = done->costBefore;
    const StopsAround around = [this](std::size_t stop) { return stopsNear(map_.stops[stop].pose.translation, stop); };
    if (fusePlanes(map_, extents_, around, parameters_.gap) > 0)
        done = adjustWhole();
    if (done)
        done = adjustToUnevenness(*done);
    if (done)
        done->costBefore = costBefore;
    return done;
}

/// Stops join by what was told, so that no match is missed; the whole map shows how even its walls are.
Result<MapAdjustment> MapBuilder::adjustToUnevenness(const MapAdjustment& adjusted)
{
    std::vector<std::shared_ptr<const Stop>> told;
    for (const MapStop& stop : map_.stops)
        told.push_back(stop.stop);
    Result<MapAdjustment> done = adjusted;
    double flatness = parameters_.flatness;
    for (int round = 0; round < kFlatnessRounds && done; ++round) {
        const double found = unevennessOf(map_, flatness, parameters_.flatness);
        if (!(found < kSameFlatness * flatness))
            break;
        changeFlatness(map_, flatness, found);
        flatness = found;
        done = adjustWhole();
    }
    // Seen this closely, some of what matched by what was told does not.
    for (int round = 0; round < kContradictionRounds && done; ++round) {
        BuildingMap other = map_;
        if (divideContradictions(other) == 0)
            break;
        std::swap(map_, other);
        const auto divided = adjustWhole();
        if (!divided) {
            // A stop rests on what was divided.
            std::swap(map_, other);
            break;
        }
        done = divided;
    }
    for (std::size_t stop = 0; stop < told.size(); ++stop)
        map_.stops[stop].stop = told[stop];
    return done;
}

Result<MapAdjustment> MapBuilder::adjustWhole()
{
    auto done = adjustMap(map_);
    if (!done)
        return done;
    if (auto computed = computeCovariances(map_); !computed)
        return tl::unexpected(computed.error());
    return done;
}

void MapBuilder::adjustNear(std::size_t number, std::span<const std::size_t> near)
{
    std::vector<std::pair<int, std::size_t>> shared;
    for (const std::size_t stop : near) {
        int count = 0;
        for (const MapMatch& match : map_.stops[stop].matches) {
            count += match.plane && std::ranges::any_of(map_.stops[number].matches,
                                                        [&](const MapMatch& own) { return own.plane == match.plane; })
                         ? 1
                         : 0;
        }
        shared.emplace_back(-count, stop);
    }
    std::ranges::sort(shared);
    std::vector<std::size_t> adjusted{number};
    for (const auto& [count, stop] : shared) {
        if (adjusted.size() <= kAdjustedWith && count < 0)
            adjusted.push_back(stop);
    }
    std::vector<Eigen::Vector3d> before;
    before.reserve(adjusted.size());
    for (const std::size_t stop : adjusted)
        before.push_back(map_.stops[stop].pose.translation);
    // Where it finds no solution the stop stays as it was registered.
    if (!adjustStops(map_, adjusted))
        return;
    for (std::size_t i = 0; i < adjusted.size(); ++i)
        index_.move(adjusted[i], before[i], map_.stops[adjusted[i]].pose.translation);
}

}  // namespace planewright
