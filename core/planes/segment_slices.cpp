// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/planes/segment_slices.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Core>

namespace planewright {

namespace {

/// The pitch of a slice from where its laser stood, Eq. (6), or, with the laser on the pitch axis, from the end point
/// that is farthest ahead: with beams that look behind this may be half a turn off, where ahead and behind change names
/// and nothing else.
double tiltOf(const Segments& segments, const ScanDescription& description)
{
    const Eigen::Quaterniond back = description.attitude.conjugate();
    const Eigen::Vector3d origin =
        description.isTurned() ? back * segments.front().viewpoint : segments.front().viewpoint;
    if (description.pitchAxisOffset != 0.0)
        return std::atan2(origin.z() / description.pitchAxisOffset, origin.y() / description.pitchAxisOffset);
    Eigen::Vector3d farthest = Eigen::Vector3d::Zero();
    for (const LineSegment& segment : segments) {
        for (Eigen::Vector3d point : {segment.start, segment.end}) {
            if (description.isTurned())
                point = back * point;
            if (point.tail<2>().squaredNorm() > farthest.tail<2>().squaredNorm())
                farthest = point;
        }
    }
    return std::atan2(farthest.y(), -farthest.z());
}

}  // namespace

SegmentSlices slicesOf(std::span<const SegmentId> segments, const SegmentLog& log, const ScanDescription& description)
{
    std::vector<SegmentId> wanted(segments.begin(), segments.end());
    std::sort(wanted.begin(), wanted.end());
    wanted.erase(std::unique(wanted.begin(), wanted.end()), wanted.end());
    std::erase_if(wanted, [&](const SegmentId& id) {
        const std::size_t place = log.find(id.step);
        return place == log.slices() || id.index < 0 || static_cast<std::size_t>(id.index) >= log.slice(place).size();
    });
    SegmentSlices slices;
    if (wanted.empty())
        return slices;
    auto next = wanted.begin();
    for (std::size_t place = log.find(wanted.front().step); next != wanted.end(); ++place) {
        const Segments& all = log.slice(place);
        if (all.empty())
            continue;
        SegmentSlice slice{log.stepOf(place), tiltOf(all, description), {}};
        for (; next != wanted.end() && next->step == slice.step; ++next)
            slice.segments.push_back(all[static_cast<std::size_t>(next->index)]);
        slices.push_back(std::move(slice));
    }
    return slices;
}

}  // namespace planewright
