// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "core/mapping/adjust_map.h"
#include "core/mapping/building_map.h"
#include "core/mapping/decide_stop.h"
#include "core/mapping/match_stop.h"
#include "core/mapping/stop_index.h"
#include "core/mapping/stop_tree.h"
#include "core/params/mapping_parameters.h"
#include "core/types/error.h"

namespace planewright {

/// How a stop came into the map.
struct JoinReport {
    std::size_t stop = 0;  ///< in BuildingMap::stops
    StopTrust trust = StopTrust::Unplaced;
    int matched = 0;          ///< of its planes
    int fresh = 0;            ///< planes that are new in the map
    int open = 0;             ///< planes that may be one of several
    bool cutShort = false;    ///< a search met its limit: more may have matched
    bool closedLoop = false;  ///< it came back to where the map was older
    double drift = 0.0;       ///< of the way round that was taken out when it did [m]
};

/// Makes a map of a floor out of stops, one after the other: stop, scan, go (Appendix B).
///
/// A stop is expected where odometry says, matched with the planes that stops near by saw, registered, and adjusted
/// together with the stops next to it. Then it is compared with what older stops know of the place: that closes loops.
/// Its planes are also looked for without the odometry; where they tell of another pose, that is said. The work for a
/// stop does not depend on how many there are; `adjust` goes over the whole map.
///
/// The same stops give the same map, bit for bit.
class MapBuilder {
public:
    explicit MapBuilder(const MappingParameters& parameters = {});

    /// Adds a stop. The first one is the frame of the map. A stop that cannot be placed stays in the list, is no part
    /// of the map, and odometry goes on from where it is expected. Fails with Unreadable where a number of the stop is
    /// not finite or a covariance not positive, and names it; the map is as it was.
    Result<JoinReport> join(Stop stop);

    /// Adjusts the whole map, and computes the covariances of all poses and planes.
    Result<MapAdjustment> adjust();

    /// Says by hand what plane of the map a stop's plane is, or with nothing, that it is one of its own. Fails with
    /// Usage where there is no such plane. The map follows at the next `adjust`.
    Result<void> match(std::size_t stop, std::size_t plane, std::optional<std::size_t> mapPlane);

    const BuildingMap& map() const { return map_; }

private:
    /// Where odometry expects a stop.
    struct Expectation {
        PosePrior prior;       ///< its covariance is against `base`
        std::size_t base = 0;  ///< the placed stop that odometry leads on from
    };

    /// What came of matching a stop with others.
    struct Attempt {
        std::size_t base = 0;           ///< the stop that poses and covariances are against
        std::vector<std::size_t> near;  ///< the stops whose planes were looked at
        StopDecision decision;
    };

    Attempt attemptNear(const Stop& stop, const StopExtents& extents, const Expectation& expected) const;
    Attempt attemptAnywhere(const Stop& stop, const StopExtents& extents) const;
    std::optional<Expectation> expectationOf(const Stop& stop) const;
    StopMotion motionOf(const Expectation& expected) const;
    std::vector<std::size_t> stopsNear(const Eigen::Vector3d& place, std::size_t base) const;
    bool isNear(std::size_t a, std::size_t b) const;
    Result<MapAdjustment> adjustAndDecide();
    Result<MapAdjustment> adjustToUnevenness(const MapAdjustment& adjusted);
    Result<MapAdjustment> adjustWhole();
    void addStop(MapStop stop, StopExtents extents);
    void addMatches(const StopMatch& match);
    void adjustNear(std::size_t number, std::span<const std::size_t> near);
    void closeLoop(std::size_t number, std::size_t base, JoinReport& report);
    void mergeWithOlder(std::size_t number, const StopMatch& older);
    void noteSeenThrough(std::size_t number, std::span<const std::size_t> near);
    JoinReport reportOf(std::size_t number) const;

    MappingParameters parameters_;
    BuildingMap map_;
    std::vector<StopExtents> extents_;  ///< of each stop
    StopTree tree_;
    StopIndex index_;
};

}  // namespace planewright
