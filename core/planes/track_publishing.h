// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>

#include "core/planes/track_map.h"

namespace planewright {

/// How people and files call a segment.
inline SegmentId idOf(SegmentNumber number, const TrackMap& map)
{
    const TrackedSlice& slice = map.slice(map.segment(number).slice);
    return {slice.step, number - slice.first};
}

/// Unit vector of a segment in space.
inline Eigen::Vector3d directionOf(SegmentNumber number, const TrackMap& map)
{
    const TrackedSegment& s = map.segment(number);
    return map.slice(s.slice).frame.directionAt(s.statistics.directionU, s.statistics.directionV);
}

/// Mean squared Mahalanobis distance of a plane's segments: 1 is expected.
double meanErrorOf(const PlaneTrack& plane);

/// Up to where it is chance (`likelihood.split-sigmas`).
double largestMeanError(const PlaneTrack& plane, const Parameters& parameters);

/// The segments of a slice as snapshots show them: end points are those of the fitted line, projected.
Segments segmentsOf(int place, const TrackMap& map, const SensorModel& sensor, const NoiseParameters& noise);

/// The plane and the cluster as snapshots show them; the same object as long as nothing changed.
std::shared_ptr<const Plane> publishedPlane(PlaneTrack& plane, const TrackMap& map);
std::shared_ptr<const DirectionCluster> publishedCluster(GrowingCluster& cluster, const TrackMap& map);

}  // namespace planewright
