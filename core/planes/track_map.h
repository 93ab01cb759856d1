// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "core/clusters/direction_clusters.h"
#include "core/planes/plane_estimate.h"
#include "core/planes/plane_kernels.h"
#include "core/types/plane.h"
#include "core/types/step_recorder.h"

namespace planewright {

/// A slice among the segments of the scan.
struct TrackedSlice {
    int step = 0;
    SliceFrame frame;
    SegmentNumber first = 0;  ///< its segments are [first, end)
    SegmentNumber end = 0;
    int lookback = 0;  ///< how many slices before it count as next to it
};

/// First and last beam of a segment among those of the scan's first slice: interlaced scanners start elsewhere.
struct BeamSpan {
    int first = 0;
    int last = 0;
};

/// A line segment as planes are made of it.
struct TrackedSegment {
    SegmentStatistics statistics;
    int slice = 0;             ///< place of its slice
    PlaneId owner = kNoPlane;  ///< the plane that it belongs to
    int contested = -1;        ///< the plane of `contestedPlanes` that it was on last; −1 for none
    std::int64_t left = -1;    ///< moment at which no plane was found for it; −1 for none
};

/// A plane that follows its segments from slice to slice.
struct PlaneTrack {
    PlaneId id = kNoPlane;
    PlaneEstimate estimate;
    std::vector<SegmentNumber> members;  ///< in order
    int fitted = 0;                      ///< of these, how many the last fit took
    std::int64_t points = 0;
    int slices = 0;                 ///< that its members are of
    int lastSlice = -1;             ///< place of the last of them
    std::int64_t linearisedAt = 0;  ///< points when it was linearised last
    int slicesUnsolved = 0;         ///< slices added since it was solved last
    std::int64_t comparedAt = 0;    ///< points when it was compared for merging last
    std::int64_t contestedAt = 0;   ///< points when it was asked last whether runs lean out of it
    bool ofPair = false;            ///< made of two facing segments: two slices are enough for it
    int bornStep = 0;
    int changedStep = 0;
    std::uint64_t revision = 0;
    Lineage lineage;
    std::int64_t changedAt = 0;   ///< moment at which its estimate or its members changed last
    std::int64_t foundedAt = -1;  ///< moment at which it was found large, wide and flat enough; −1 for none
    std::int64_t reducedAt = -1;  ///< moment at which reducedChi was worked out; −1 for none
    double reducedChi = 0.0;      ///< mean of its segments' squared residuals
    PlaneInSlice seen;            ///< the plane in the slice seenIn
    int seenIn = -1;
    std::shared_ptr<const Plane> published;
};

/// What the extraction by likelihood knows between two steps.
class TrackMap {
public:
    /// Takes in the segments of the next slice.
    void append(const ScanSlice& slice, const SensorModel& sensor, std::span<const SegmentStatistics> segments);

    int slices() const { return static_cast<int>(slices_.size()); }
    const TrackedSlice& slice(int place) const { return slices_[static_cast<std::size_t>(place)]; }
    SegmentNumber segments() const { return static_cast<SegmentNumber>(segments_.size()); }
    TrackedSegment& segment(SegmentNumber number) { return segments_[static_cast<std::size_t>(number)]; }
    const TrackedSegment& segment(SegmentNumber number) const { return segments_[static_cast<std::size_t>(number)]; }

    std::vector<PlaneTrack>& planes() { return planes_; }
    const std::vector<PlaneTrack>& planes() const { return planes_; }
    PlaneTrack& plane(PlaneId id)
    {
        const std::size_t place = lastPlace_[static_cast<std::size_t>(id)];
        return place < planes_.size() && planes_[place].id == id ? planes_[place] : findPlane(id);
    }

    /// How many slices back, and how many ahead, count as next to a slice: two, or those within a degree and a half.
    int lookback(int place) const { return slice(place).lookback; }
    int lookahead(int place) const { return neighbours(place, 1); }
    /// Mean angle between neighbouring slices so far [rad].
    double meanTiltStep() const;
    double bearingStep() const { return bearingStep_; }
    /// A direction of the frame that the planes are in, that of Eq. (6), in the recording's.
    Eigen::Vector3d turned(const Eigen::Vector3d& vector) const { return sensor_.turned(vector); }

    const BeamSpan& beams(SegmentNumber number) const { return beams_[static_cast<std::size_t>(number)]; }

    /// Calls `visit(SegmentNumber)` for each segment of a slice that overlaps these beams within a margin.
    template <class Visit>
    void visitOverlaps(int place, const BeamSpan& beams, int margin, Visit visit) const
    {
        const TrackedSlice& at = slice(place);
        for (SegmentNumber i = at.first; i < at.end; ++i) {
            const BeamSpan& other = beams_[static_cast<std::size_t>(i)];
            if (other.last + margin < beams.first)
                continue;
            if (other.first > beams.last + margin)
                break;
            visit(i);
        }
    }

    /// The plane as it is seen in a slice.
    const PlaneInSlice& seenIn(PlaneTrack& plane, int place)
    {
        if (plane.seenIn != place) {
            plane.estimate.look(slice(place).frame, plane.seen);
            plane.seenIn = place;
        }
        return plane.seen;
    }

    /// χ² of a segment against a plane; infinite where it is sure to reach the limit.
    double joinChi(PlaneTrack& plane, SegmentNumber number, const NoiseParameters& noise, double floor,
                   double limit = std::numeric_limits<double>::infinity())
    {
        const TrackedSegment& s = segment(number);
        return plane.estimate.joinChi(seenIn(plane, s.slice), s.statistics, noise, floor, limit);
    }

    /// Where a segment's centroid is in space [m].
    Eigen::Vector3d centroid(SegmentNumber number) const
    {
        const TrackedSegment& s = segment(number);
        return slice(s.slice).frame.pointAt(s.statistics.u, s.statistics.v);
    }

    /// Sine of the angle at which the ray to a segment's centroid meets a plane.
    double incidence(SegmentNumber number, const PlaneEstimate& estimate) const;
    /// The same on average over a plane's points. Near zero it is a slice's own plane, which fits all of the slice.
    double meanIncidence(const PlaneTrack& plane) const;

    /// Makes a plane of these segments, which belong to none. None where they do not determine one.
    PlaneTrack* makePlane(std::vector<SegmentNumber> members, const PlaneEstimate& start, int step,
                          const Parameters& parameters);

    /// Adds segments of one slice to a plane; it is solved anew when due.
    void join(PlaneTrack& plane, std::span<const SegmentNumber> numbers, int step, const Parameters& parameters);

    /// The segments to be asked about a plane together; they hold until the next are.
    const SegmentBatch& together(std::span<const SegmentNumber> numbers);

    /// Works the plane out anew from these of its members, in order, linearised where it is now, with a floor [m] of
    /// what a segment may be off as a whole.
    bool rebuild(PlaneTrack& plane, const SegmentBatch& counting, const NoiseParameters& noise, double floor);
    /// The same with all members and the floor of growing planes (`noise.systematic`).
    bool rebuild(PlaneTrack& plane, const Parameters& parameters);

    /// Gives these planes the segments that say they are theirs, after owners were changed; those without any
    /// disappear. A plane may be named more than once. Returns those that are left, in order of id.
    std::vector<PlaneTrack*> collectMembers(std::span<const PlaneId> changed, int step);

    /// Takes a segment away from its plane; the plane's members are the caller's to set.
    void free(SegmentNumber number)
    {
        segment(number).owner = kNoPlane;
        freed_.push_back(number);
    }

    /// Removes a plane and frees its segments.
    void dissolve(PlaneId id);

    /// Takes the segments that belong to a plane out of the clusters, and gives those, in order, that were freed since
    /// this was asked last, belong to no other plane by now, and are in no cluster.
    std::vector<SegmentNumber> settleClusters();

    void touch(PlaneTrack& plane, int step);
    /// Tells that a plane's estimate or its members changed.
    void stamp(PlaneTrack& plane) { plane.changedAt = ++moment_; }

    /// Moments count changes of planes: what was found out about a plane holds until it changes, or the parameters do.
    std::int64_t moment() const { return moment_; }
    bool holds(const PlaneTrack& plane, std::int64_t found) const
    {
        return found >= parametersSince_ && plane.changedAt <= found;
    }
    /// Tells that what follows is judged by other parameters than before.
    void parametersChanged() { parametersSince_ = ++moment_; }

    DirectionClusters clusters;
    std::vector<PlaneEstimate> contestedPlanes;  ///< those that were taken apart because runs lean out of them

    /// Storage of the stage that gives segments to planes, kept from slice to slice.
    struct Joining {
        std::vector<std::pair<PlaneId, SegmentNumber>> joined;
        std::vector<SegmentNumber> together;  ///< those of one plane
        std::vector<SegmentNumber> left;      ///< those of none
    };
    Joining joining;

private:
    int neighbours(int place, int direction) const;
    PlaneTrack& findPlane(PlaneId id);

    std::vector<TrackedSlice> slices_;
    std::vector<TrackedSegment> segments_;
    std::vector<BeamSpan> beams_;         // of each segment
    std::vector<PlaneTrack> planes_;      // in order of id
    std::vector<std::size_t> lastPlace_;  // where the plane of an id was among them when it was asked for last
    PlaneId nextPlane_ = 0;
    std::int64_t moment_ = 0;
    std::int64_t parametersSince_ = 0;
    SensorModel sensor_;
    double bearingStep_ = 0.0;
    double firstBearing_ = 0.0;
    double tiltTravelled_ = 0.0;
    std::vector<SegmentNumber> freed_;
    std::vector<const SegmentStatistics*> group_;
    SegmentBatch together_;
};

}  // namespace planewright
