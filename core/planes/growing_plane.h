// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <memory>
#include <vector>

#include "core/planes/plane_fit.h"
#include "core/planes/segment_table.h"
#include "core/types/plane.h"

namespace planewright {

/// A plane while segments join and leave it.
///
/// The end points enter weighted sums, so that the refit after every few segments costs the same however large the
/// plane has grown. Their weights are those of the plane at the time; when it has grown by half since, it is refined
/// over all its end points and the sums are made anew.
class GrowingPlane {
public:
    /// A plane from a fit to these segments.
    GrowingPlane(PlaneId id, const PlaneFit& fit, std::vector<SegmentNumber> members, const SegmentTable& table,
                 const PlaneParameters& parameters, int step);

    /// Adds a segment; the plane stays where it is until it is refitted.
    void add(SegmentNumber segment, const SegmentTable& table, const PlaneParameters& parameters, int step);

    /// Takes over all of another plane's segments, and refines over all.
    void absorb(const GrowingPlane& other, const SegmentTable& table, const PlaneParameters& parameters, int step);

    /// Replaces the segments; the plane stays where it is until it is refined.
    void setMembers(std::vector<SegmentNumber> members, const SegmentTable& table, const PlaneParameters& parameters,
                    int step);

    /// Fits the plane to its sums, or refines it over all end points when it has grown much since that was done last.
    void refit(const SegmentTable& table, const PlaneParameters& parameters, int step);

    /// Refines the plane over all its end points (Table VI) and makes the sums anew.
    void refine(const SegmentTable& table, const PlaneParameters& parameters, int step);

    /// Whether it has grown by a quarter since the last time that it had: enough to look at its segments again.
    bool hasGrownSinceAsked();

    /// The same, unless nothing has changed since the plane was refined last.
    void refineIfChanged(const SegmentTable& table, const PlaneParameters& parameters, int step);

    /// Tells a plane made of one that was split or merged.
    void setLineage(Lineage lineage) { lineage_ = std::move(lineage); }

    /// Counts on where a plane of the same id left off that this one replaces.
    void continueFrom(const GrowingPlane& before, int step);

    PlaneId id() const { return id_; }
    const Eigen::Vector3d& normal() const { return fit_.normal; }
    double distance() const { return fit_.distance; }
    double distanceTo(const Eigen::Vector3d& point) const { return std::abs(fit_.normal.dot(point) - fit_.distance); }
    /// Variance of the plane's place at a point, along its normal [m²].
    double varianceAt(const Eigen::Vector3d& point) const;
    /// Largest variance of the normal's direction [rad²].
    double normalVariance() const { return largestNormalVariance(covariance_); }
    /// E by the cost in force over the end points.
    double error() const { return fit_.error; }
    const WeightedSums& sums() const { return sums_; }
    const std::vector<SegmentNumber>& members() const { return members_; }
    int addedSinceRefit() const { return addedSinceRefit_; }
    int bornStep() const { return bornStep_; }
    int changedStep() const { return changedStep_; }
    /// End points farthest along ±x, ±y and ±z: enough to tell most planes apart without looking at all end points.
    const std::array<Eigen::Vector3d, 6>& extremes() const { return extremes_; }

    /// The plane as snapshots show it; the same object as long as nothing changed.
    std::shared_ptr<const Plane> publish(const SegmentTable& table);

private:
    void take(SegmentNumber segment, const SegmentTable& table, const PlaneParameters& parameters);
    void setFit(const PlaneFit& fit);
    void changed(int step);

    PlaneId id_;
    PlaneFit fit_;
    Eigen::Matrix3d covariance_;  // inverse of fit_.information
    std::vector<SegmentNumber> members_;
    WeightedSums sums_;
    PointMoments moments_;
    std::array<Eigen::Vector3d, 6> extremes_;
    int addedSinceRefit_ = 0;
    std::size_t refinedAt_ = 0;
    bool refined_ = false;  // and nothing has changed since
    std::size_t askedAt_ = 0;
    int bornStep_;
    int changedStep_;
    std::uint64_t revision_ = 0;
    Lineage lineage_;
    std::shared_ptr<const Plane> published_;
};

/// The end points of segments with their covariances.
std::vector<EndPoint> endPointsOf(const std::vector<SegmentNumber>& segments, const SegmentTable& table);

}  // namespace planewright
