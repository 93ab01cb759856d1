// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

#include "core/types/snapshot.h"

namespace planewright {

inline bool areSame(const LineSegment& a, const LineSegment& b)
{
    return a.id == b.id && a.firstBeam == b.firstBeam && a.lastBeam == b.lastBeam && a.points == b.points &&
           a.start == b.start && a.end == b.end && a.startCovariance == b.startCovariance &&
           a.endCovariance == b.endCovariance && a.moments.scatter == b.moments.scatter;
}

inline bool areSame(const Plane& a, const Plane& b)
{
    return a.id == b.id && a.revision == b.revision && a.normal == b.normal && a.distance == b.distance &&
           a.fittingError == b.fittingError && a.rms == b.rms && a.covariance == b.covariance &&
           a.segments == b.segments && a.bornStep == b.bornStep && a.changedStep == b.changedStep &&
           a.lineage.kind == b.lineage.kind && a.lineage.parents == b.lineage.parents;
}

inline bool areSame(const DirectionCluster& a, const DirectionCluster& b)
{
    return a.id == b.id && a.direction == b.direction && a.segments == b.segments;
}

/// What differs first between two states of an extraction, bit for bit; empty where nothing does. Times, decisions and
/// splits and merges are not compared.
inline std::string differenceOf(const Snapshot& a, const Snapshot& b)
{
    if (a.report.step != b.report.step)
        return "step";
    const StepCounts& p = a.report.counts;
    const StepCounts& q = b.report.counts;
    if (p.segments != q.segments || p.assigned != q.assigned || p.clustered != q.clustered || p.fitted != q.fitted ||
        p.unfitted != q.unfitted || p.clusters != q.clusters || p.planes != q.planes || p.meanError != q.meanError ||
        p.returns != q.returns)
        return "counts";
    if (a.noise.rangeConstant != b.noise.rangeConstant || a.noise.pitch != b.noise.pitch)
        return "noise";
    if (a.segments.slices() != b.segments.slices() || a.segments.segmentCount() != b.segments.segmentCount())
        return "number of segments";
    for (std::size_t slice = 0; slice < a.segments.slices(); ++slice) {
        for (std::size_t i = 0; i < a.segments.slice(slice).size(); ++i) {
            if (!areSame(a.segments.slice(slice)[i], b.segments.slice(slice)[i]))
                return "segment " + std::to_string(a.segments.stepOf(slice)) + "." + std::to_string(i);
        }
    }
    if (a.planes.size() != b.planes.size())
        return "number of planes";
    for (std::size_t i = 0; i < a.planes.size(); ++i) {
        if (!areSame(*a.planes[i], *b.planes[i]))
            return "plane " + std::to_string(a.planes[i]->id);
    }
    if (a.clusters.size() != b.clusters.size())
        return "number of clusters";
    for (std::size_t i = 0; i < a.clusters.size(); ++i) {
        if (!areSame(*a.clusters[i], *b.clusters[i]))
            return "cluster " + std::to_string(a.clusters[i]->id);
    }
    return {};
}

}  // namespace planewright
