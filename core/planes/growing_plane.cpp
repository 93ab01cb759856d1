// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/planes/growing_plane.h"

#include <algorithm>
#include <cmath>

namespace planewright {

std::vector<EndPoint> endPointsOf(const std::vector<SegmentNumber>& segments, const SegmentTable& table)
{
    std::vector<EndPoint> points;
    points.reserve(2 * segments.size());
    for (const SegmentNumber number : segments) {
        const LineSegment& segment = table[number];
        points.push_back({segment.start, segment.startCovariance});
        points.push_back({segment.end, segment.endCovariance});
    }
    return points;
}

GrowingPlane::GrowingPlane(PlaneId id, const PlaneFit& fit, std::vector<SegmentNumber> members,
                           const SegmentTable& table, const PlaneParameters& parameters, int step)
    : id_(id), bornStep_(step), changedStep_(step)
{
    setFit(fit);
    setMembers(std::move(members), table, parameters, step);
    revision_ = 0;
    refinedAt_ = members_.size();
}

void GrowingPlane::setMembers(std::vector<SegmentNumber> members, const SegmentTable& table,
                              const PlaneParameters& parameters, int step)
{
    std::sort(members.begin(), members.end());
    if (members == members_)
        return;
    sums_ = {};
    moments_ = {};
    if (!members.empty())
        extremes_.fill(table[members.front()].start);
    for (const SegmentNumber segment : members)
        take(segment, table, parameters);
    members_ = std::move(members);
    changed(step);
}

void GrowingPlane::take(SegmentNumber segment, const SegmentTable& table, const PlaneParameters& parameters)
{
    const LineSegment& added = table[segment];
    for (const EndPoint& point :
         {EndPoint{added.start, added.startCovariance}, EndPoint{added.end, added.endCovariance}})
        sums_.add(point.position, endPointWeight(fit_.normal, point, parameters));
    for (const Eigen::Vector3d& point : {added.start, added.end}) {
        for (Eigen::Index axis = 0; axis < 3; ++axis) {
            Eigen::Vector3d& lowest = extremes_[static_cast<std::size_t>(2 * axis)];
            Eigen::Vector3d& highest = extremes_[static_cast<std::size_t>(2 * axis + 1)];
            if (point[axis] < lowest[axis])
                lowest = point;
            if (point[axis] > highest[axis])
                highest = point;
        }
    }
    moments_ += added.moments;
}

void GrowingPlane::setFit(const PlaneFit& fit)
{
    fit_ = fit;
    covariance_ = covarianceOf(fit);
}

double GrowingPlane::varianceAt(const Eigen::Vector3d& point) const
{
    Eigen::Vector3d row;
    row << fit_.tangents.transpose() * point, -1.0;
    return row.dot(covariance_ * row);
}

void GrowingPlane::changed(int step)
{
    changedStep_ = step;
    refined_ = false;
    ++revision_;
    published_ = nullptr;
}

void GrowingPlane::add(SegmentNumber segment, const SegmentTable& table, const PlaneParameters& parameters, int step)
{
    take(segment, table, parameters);
    members_.insert(std::upper_bound(members_.begin(), members_.end(), segment), segment);
    ++addedSinceRefit_;
    fit_.error = sums_.meanError(fit_.normal, fit_.distance);
    changed(step);
}

void GrowingPlane::absorb(const GrowingPlane& other, const SegmentTable& table, const PlaneParameters& parameters,
                          int step)
{
    std::vector<SegmentNumber> all(members_.size() + other.members_.size());
    std::merge(members_.begin(), members_.end(), other.members_.begin(), other.members_.end(), all.begin());
    members_ = std::move(all);
    moments_ += other.moments_;
    for (std::size_t i = 0; i < extremes_.size(); ++i) {
        const auto axis = static_cast<Eigen::Index>(i / 2);
        const bool lowest = i % 2 == 0;
        if ((other.extremes_[i][axis] < extremes_[i][axis]) == lowest)
            extremes_[i] = other.extremes_[i];
    }
    refine(table, parameters, step);
}

bool GrowingPlane::hasGrownSinceAsked()
{
    if (4 * members_.size() < 5 * askedAt_)
        return false;
    askedAt_ = members_.size();
    return true;
}

void GrowingPlane::refit(const SegmentTable& table, const PlaneParameters& parameters, int step)
{
    if (2 * members_.size() >= 3 * refinedAt_) {
        refine(table, parameters, step);
        return;
    }
    setFit(fitPlane(sums_, fit_.normal));
    addedSinceRefit_ = 0;
    changed(step);
}

void GrowingPlane::refine(const SegmentTable& table, const PlaneParameters& parameters, int step)
{
    const std::vector<EndPoint> points = endPointsOf(members_, table);
    setFit(refinePlane(fit_, points, parameters));
    sums_ = {};
    for (const EndPoint& point : points)
        sums_.add(point.position, endPointWeight(fit_.normal, point, parameters));
    refinedAt_ = members_.size();
    addedSinceRefit_ = 0;
    changed(step);
    refined_ = true;
}

void GrowingPlane::refineIfChanged(const SegmentTable& table, const PlaneParameters& parameters, int step)
{
    if (!refined_)
        refine(table, parameters, step);
}

void GrowingPlane::continueFrom(const GrowingPlane& before, int step)
{
    revision_ = before.revision_;
    lineage_ = before.lineage_;
    changed(step);
}

std::shared_ptr<const Plane> GrowingPlane::publish(const SegmentTable& table)
{
    if (published_)
        return published_;
    auto plane = std::make_shared<Plane>();
    plane->id = id_;
    plane->revision = revision_;
    plane->normal = fit_.normal;
    plane->distance = fit_.distance;
    plane->fittingError = fit_.error;
    plane->rms = std::sqrt(std::max(0.0, moments_.squaredDistanceTo(fit_.normal, fit_.distance)) / moments_.count);
    makeCanonical(plane->normal, plane->distance);
    // Turning n and d round turns both tangent angles and d's error round: their covariance stays as it is.
    plane->tangents = fit_.tangents;
    plane->covariance = covariance_;
    plane->segments.reserve(members_.size());
    for (const SegmentNumber segment : members_)
        plane->segments.push_back(table[segment].id);
    plane->points = static_cast<int>(moments_.count);
    plane->bornStep = bornStep_;
    plane->changedStep = changedStep_;
    plane->lineage = lineage_;
    published_ = std::move(plane);
    return published_;
}

}  // namespace planewright
