// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <limits>
#include <span>

#include <Eigen/Core>

#include "core/geometry/sensor_model.h"
#include "core/params/parameters.h"
#include "core/segments/segment_statistics.h"

namespace planewright {

/// The plane of a slice in space: a point (u, v) of it is origin + u x + v ahead, Eq. (6).
struct SliceFrame {
    double tilt = 0.0;                                       ///< φ [rad]
    Eigen::Vector3d ahead = Eigen::Vector3d::UnitY();        ///< ∂p/∂v
    Eigen::Vector3d origin = Eigen::Vector3d::Zero();        ///< where the laser is [m]
    Eigen::Vector3d aheadTurned = Eigen::Vector3d::UnitZ();  ///< ∂ahead/∂φ
    Eigen::Vector3d originTurned = Eigen::Vector3d::Zero();  ///< ∂origin/∂φ [m]

    Eigen::Vector3d pointAt(double u, double v) const
    {
        return {origin.x() + u + v * ahead.x(), origin.y() + v * ahead.y(), origin.z() + v * ahead.z()};
    }
    /// A direction (u, v) of it in space; no zero is negative.
    Eigen::Vector3d directionAt(double u, double v) const
    {
        return {u + v * ahead.x(), 0.0 + v * ahead.y(), 0.0 + v * ahead.z()};
    }
};

/// The frame of a slice at this tilt [rad].
SliceFrame frameOf(double tilt, const SensorModel& sensor);

/// A linear function of the slice's coordinates: u·(…) + v·(…) + constant.
template <class Number>
struct SliceFunctionOf {
    Number u{}, v{}, constant{};

    double at(double pointU, double pointV) const { return u * pointU + v * pointV + constant; }
};

/// No steepness is taken for smaller, that of 3°: to a plane that holds the slice itself every line would be exact, and
/// at that angle none can be told to belong.
inline constexpr double kLeastSteepness = 2.7e-3;

/// What a plane and the directions it can move in look like in a slice.
template <class Number>
struct PlaneInSliceOf {
    SliceFunctionOf<Number> distance;  ///< n·p − d
    SliceFunctionOf<Number> first;     ///< its derivative by the first tangent angle
    SliceFunctionOf<Number> second;    ///< by the second
    SliceFunctionOf<Number> pitch;     ///< by the slice's pitch
    Number steepness{};  ///< square of the distance's gradient in the slice: how noise across a line enters it
};
using PlaneInSlice = PlaneInSliceOf<double>;

class SegmentBatch;
struct AskedPlane;
struct PlaneKernels;
/// The fastest loops over segments that this processor can run.
const PlaneKernels& planeKernels();
template <class Number>
struct SegmentSums;

/// What a segment tells of its slice's pitch error: sums over segments, of which gradient over information is the
/// error.
struct PitchEvidence {
    double information = 0.0;  ///< [1/rad²]
    double gradient = 0.0;     ///< [1/rad]
};

/// What two planes are apart.
struct PlaneDisparity {
    double chi = 0.0;          ///< χ² of 3 degrees of freedom
    double determinant = 0.0;  ///< of the covariance that it is told by [rad⁴ m²]
};

/// A plane by maximum likelihood: its parameters, their information and their covariance.
///
/// Unknowns are two tangent angles and d, from a linearisation point on; information and gradient are sums over slices,
/// in each of which the pitch error is one unknown that has been eliminated (Schur complement).
class PlaneEstimate {
public:
    PlaneEstimate() = default;
    /// Starts from a plane n·p = d [m] with |n| = 1 and no information.
    PlaneEstimate(const Eigen::Vector3d& normal, double distance);

    const Eigen::Vector3d& normal() const { return normal_; }
    double distance() const { return distance_; }
    /// Covariance of (tangent angle 1, tangent angle 2, d) [rad², rad·m, m²].
    const Eigen::Matrix3d& covariance() const { return covariance_; }
    const Eigen::Matrix<double, 3, 2>& tangents() const { return tangents_; }
    /// Σ of squared residuals over their variances at the estimate: the negative log likelihood twice.
    double chi() const { return chi_ + 2.0 * gradient_.dot(step_) + step_.dot(information_ * step_); }
    /// Largest variance of the normal [rad²].
    double normalVariance() const { return normalVariance_; }
    /// Variance of the plane's distance to a point in space [m] [m²]: large where the plane goes on far from what told
    /// it.
    double varianceAt(const Eigen::Vector3d& point) const
    {
        const Eigen::Vector3d row{tangents_.col(0).dot(point), tangents_.col(1).dot(point), -1.0};
        return row.dot(covariance_ * row);
    }
    /// Adds to the covariance what independent errors of standard deviation 1 do, each common to all that was added, of
    /// which these are the gradients in tangents(): information times the change of the parameters.
    void addCommonErrors(std::span<const Eigen::Vector3d> gradients);
    /// How far the estimate is from where it was linearised [rad].
    double angleFromLinearisation() const { return step_.head<2>().norm(); }

    /// The same plane with the same covariance, linearised where it is, without the segments that told.
    PlaneEstimate afresh() const;

    PlaneInSlice inSlice(const SliceFrame& frame) const
    {
        PlaneInSlice seen;
        look(frame, seen);
        return seen;
    }
    /// The same, written where it is to stay.
    void look(const SliceFrame& frame, PlaneInSlice& seen) const
    {
        const double u = start_.x();
        const double v = start_.dot(frame.ahead);
        seen.distance.u = u;
        seen.distance.v = v;
        seen.distance.constant = start_.dot(frame.origin) - startDistance_;
        seen.first.u = tangents_(0, 0);
        seen.first.v = tangents_.col(0).dot(frame.ahead);
        seen.first.constant = tangents_.col(0).dot(frame.origin);
        seen.second.u = tangents_(0, 1);
        seen.second.v = tangents_.col(1).dot(frame.ahead);
        seen.second.constant = tangents_.col(1).dot(frame.origin);
        seen.pitch.u = 0.0;
        seen.pitch.v = start_.dot(frame.aheadTurned);
        seen.pitch.constant = start_.dot(frame.originTurned);
        seen.steepness = std::max(kLeastSteepness, u * u + v * v);
    }

    /// Adds (sign = 1) or takes away (sign = −1) segments of one slice together. A floor [m] is what a segment
    /// may be off as a whole, beside its noise: it keeps few segments from telling more than a real sensor can.
    void accumulate(const PlaneInSlice& seen, std::span<const SegmentStatistics* const> segments,
                    const NoiseParameters& noise, double floor, double sign);

    /// Adds the segments of a batch, those of each slice together; floor as above.
    void accumulate(const SegmentBatch& batch, const NoiseParameters& noise, double floor,
                    const PlaneKernels& kernels = planeKernels());

    /// Moves to the most likely plane. False where the segments do not determine one.
    bool solve();

    /// χ² (2 degrees of freedom) of a segment against this plane: its distance and its slope, with the variances of
    /// segment, plane and pitch, and a floor [m] of what ranges may be off together. Infinite where the slice is in the
    /// plane but for 3°, and where the distance alone brings it to the limit.
    double joinChi(const PlaneInSlice& seen, const SegmentStatistics& segment, const NoiseParameters& noise,
                   double floor, double limit = std::numeric_limits<double>::infinity()) const;

    /// False where joinChi is sure to reach the limit, by the distance of a segment's centroid [m] to this plane alone;
    /// `variance` is the segment's mostVariance() [m²].
    bool mayMeet(const Eigen::Vector3d& centroid, double variance, double limit) const
    {
        const double own = (1.0 + centroid.squaredNorm()) * covariance_.trace();
        const double distance = normal_.dot(centroid) - distance_;
        return distance * distance < limit * (variance + own);
    }

    /// The same without the plane's own variance: for a segment that is already in it.
    double residualChi(const PlaneInSlice& seen, const SegmentStatistics& segment, const NoiseParameters& noise,
                       double floor) const;

    /// What a segment of this plane tells of the pitch error of its slice, with a floor [m] of what it may be off as a
    /// whole.
    PitchEvidence pitchEvidence(const PlaneInSlice& seen, const SegmentStatistics& segment,
                                const NoiseParameters& noise, double floor) const;

    /// The same for each segment of a batch: `chis` and `evidences` are as many.
    void joinChis(const SegmentBatch& batch, const NoiseParameters& noise, double floor, double limit,
                  std::span<double> chis, const PlaneKernels& kernels = planeKernels()) const;
    void residualChis(const SegmentBatch& batch, const NoiseParameters& noise, double floor, std::span<double> chis,
                      const PlaneKernels& kernels = planeKernels()) const;
    void pitchEvidences(const SegmentBatch& batch, const NoiseParameters& noise, double floor,
                        std::span<PitchEvidence> evidences, const PlaneKernels& kernels = planeKernels()) const;

    /// How far two planes are from being one, with a flatness floor [m] over an extent [m]. A plane's covariance grows
    /// by its scatter, that of its segments relative to their noise.
    PlaneDisparity disparity(const PlaneEstimate& other, double floor, double extent, double scatter = 1.0,
                             double otherScatter = 1.0) const;
    double mergeChi(const PlaneEstimate& other, double floor, double extent, double scatter = 1.0,
                    double otherScatter = 1.0) const
    {
        return disparity(other, floor, extent, scatter, otherScatter).chi;
    }

private:
    double chiOf(const PlaneInSlice& seen, const SegmentStatistics& segment, const NoiseParameters& noise, double floor,
                 double limit, bool withOwnVariance) const;
    void chisOf(const SegmentBatch& batch, const NoiseParameters& noise, double floor, double limit,
                bool withOwnVariance, std::span<double> chis, const PlaneKernels& kernels) const;
    AskedPlane asked(bool withOwnVariance) const;
    static SegmentSums<double> sumsOf(const PlaneInSlice& seen, const SegmentStatistics& segment,
                                      const NoiseParameters& noise, double floor);
    void addSlice(const SegmentSums<double>& sums, const NoiseParameters& noise, double sign);

    Eigen::Vector3d normal_ = Eigen::Vector3d::UnitZ();  // the estimate
    double distance_ = 0.0;
    Eigen::Vector3d start_ = Eigen::Vector3d::UnitZ();  // where it was linearised
    double startDistance_ = 0.0;
    Eigen::Matrix<double, 3, 2> tangents_ = Eigen::Matrix<double, 3, 2>::Zero();
    Eigen::Matrix3d information_ = Eigen::Matrix3d::Zero();
    Eigen::Vector3d gradient_ = Eigen::Vector3d::Zero();
    double chi_ = 0.0;  // at the linearisation point
    Eigen::Vector3d step_ = Eigen::Vector3d::Zero();
    Eigen::Matrix3d covariance_ = Eigen::Matrix3d::Zero();
    double normalVariance_ = 0.0;
};

/// The most that noise, pitch and a floor [m] of what its ranges may be off together make of a segment's distance to
/// any plane, by its centroid in space [m]: a variance [m²].
double mostVariance(const SegmentStatistics& segment, const Eigen::Vector3d& centroid, const NoiseParameters& noise,
                    double floor);

}  // namespace planewright
