// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "core/planes/track_map.h"
#include "core/planes/track_stages.h"
#include "tests/core/params/preset_parameters.h"
#include "tests/core/planes/recorded_decisions.h"
#include "tests/core/planes/seen_statistics.h"

namespace planewright {

using Numbers = std::vector<SegmentNumber>;

/// A wall 4 m ahead that beams 320 to 400 meet.
inline const Surface kWall{};

/// A wall 3 m to the left.
inline const Surface kSideWall{Eigen::Vector3d{-1.0, 0.0, 0.0}, 3.0, 560, 620};

/// The same wall met by other beams, or one so much farther [m].
inline Surface wallBy(int firstBeam, int lastBeam, double shift = 0.0)
{
    return {kWall.normal, kWall.distance + shift, firstBeam, lastBeam};
}

/// Tilt from slice to slice.
inline constexpr double kTiltStep = degrees(1.16);

/// A slice of the scanner without its ranges.
inline ScanSlice sliceAt(int step, double tilt)
{
    ScanSlice slice;
    slice.step = step;
    slice.tilt = tilt;
    slice.bearingStep = kBearingStep;
    slice.ranges.assign(kBeams, 0.0);
    return slice;
}

/// A map that a nodding head fills slice by slice with what it sees of surfaces.
struct NoddingScan {
    Parameters parameters = precise();
    TrackMap map;
    Recorded recorded;

    /// Adds a slice with these segments, in bearing order; gives the number of the first.
    SegmentNumber add(double tilt, const std::vector<SegmentStatistics>& segments)
    {
        map.append(sliceAt(map.slices(), tilt), kSensor, segments);
        return map.slice(map.slices() - 1).first;
    }

    /// Adds a slice that sees these surfaces, in bearing order; gives the number of the first segment.
    SegmentNumber see(double tilt, const std::vector<Surface>& surfaces)
    {
        std::vector<SegmentStatistics> segments;
        for (const Surface& surface : surfaces)
            segments.push_back(seen(surface, tilt, parameters.noise));
        return add(tilt, segments);
    }

    /// Adds slices from a tilt on, `tiltStep` apart, that all see these surfaces.
    void nod(int slices, const std::vector<Surface>& surfaces, double firstTilt = degrees(85.0),
             double tiltStep = kTiltStep)
    {
        for (int k = 0; k < slices; ++k)
            see(firstTilt + k * tiltStep, surfaces);
    }

    /// The segments at one place in the slices from first to last.
    std::vector<SegmentNumber> column(int index, int first, int last) const
    {
        std::vector<SegmentNumber> numbers;
        for (int place = first; place <= last; ++place)
            numbers.push_back(map.slice(place).first + index);
        return numbers;
    }

    /// Makes a plane of segments, linearised where a surface is; gives its id.
    PlaneId makePlane(const std::vector<SegmentNumber>& members, const Surface& surface)
    {
        const PlaneTrack* plane = map.makePlane(members, PlaneEstimate(surface.normal, surface.distance),
                                                map.slice(map.slices() - 1).step, parameters);
        return plane == nullptr ? kNoPlane : plane->id;
    }

    std::vector<PlaneId> planeIds() const
    {
        std::vector<PlaneId> ids;
        for (const PlaneTrack& plane : map.planes())
            ids.push_back(plane.id);
        return ids;
    }
};

/// Where a map's books disagree; empty where owners, members and sums of all planes agree.
inline std::string disagreement(const TrackMap& map)
{
    PlaneId before = kNoPlane;
    for (const PlaneTrack& plane : map.planes()) {
        const std::string name = "plane " + std::to_string(plane.id);
        if (plane.id <= std::exchange(before, plane.id))
            return name + " is out of order";
        std::vector<SegmentNumber> owned;
        std::vector<int> places;
        std::int64_t points = 0;
        for (SegmentNumber number = 0; number < map.segments(); ++number) {
            if (map.segment(number).owner != plane.id)
                continue;
            owned.push_back(number);
            places.push_back(map.segment(number).slice);
            points += map.segment(number).statistics.points;
        }
        places.erase(std::unique(places.begin(), places.end()), places.end());
        if (owned.empty() || plane.members != owned)
            return name + " has other members than say that they are its own";
        if (plane.points != points)
            return name + " counts other points";
        if (plane.slices != static_cast<int>(places.size()) || plane.lastSlice != places.back())
            return name + " counts other slices";
    }
    for (SegmentNumber number = 0; number < map.segments(); ++number) {
        const PlaneId owner = map.segment(number).owner;
        if (owner != kNoPlane && std::none_of(map.planes().begin(), map.planes().end(),
                                              [owner](const PlaneTrack& plane) { return plane.id == owner; }))
            return "segment " + std::to_string(number) + " belongs to a plane that is not there";
    }
    return {};
}

/// How far a plane is from a surface, whichever side its normal is on: the larger of both parameters' errors.
inline double apart(const PlaneEstimate& estimate, const Surface& surface)
{
    const double side = estimate.normal().dot(surface.normal) < 0.0 ? -1.0 : 1.0;
    return std::max((side * estimate.normal() - surface.normal).norm(),
                    std::abs(side * estimate.distance() - surface.distance));
}

/// The plane of some segments, worked out in one go from a linearisation point.
inline PlaneEstimate solvedFrom(const PlaneEstimate& start, const std::vector<SegmentNumber>& members,
                                const TrackMap& map, const NoiseParameters& noise, double floor)
{
    PlaneEstimate estimate(start.normal(), start.distance());
    for (int place = 0; place < map.slices(); ++place) {
        std::vector<const SegmentStatistics*> group;
        for (const SegmentNumber number : members) {
            if (map.segment(number).slice == place)
                group.push_back(&map.segment(number).statistics);
        }
        if (!group.empty())
            estimate.accumulate(estimate.inSlice(map.slice(place).frame), group, noise, floor, 1.0);
    }
    estimate.solve();
    return estimate;
}

/// Makes planes of what is free in a scan's slices from one on.
inline void seed(NoddingScan& scan, int firstSlice = 0)
{
    seedTracks(scan.map, firstSlice, scan.parameters, scan.recorded.recorder);
}

/// Whether two estimates and their covariances are the same but for rounding.
inline bool nearlyEqual(const PlaneEstimate& a, const PlaneEstimate& b, double tolerance)
{
    return (a.normal() - b.normal()).norm() < tolerance && std::abs(a.distance() - b.distance()) < tolerance &&
           a.covariance().isApprox(b.covariance(), 1e-6);
}

}  // namespace planewright
