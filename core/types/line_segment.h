// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <compare>
#include <vector>

#include <Eigen/Core>

namespace planewright {

/// Names a line segment for people and files: the step it was seen at and its place in that slice, as `step.index`.
struct SegmentId {
    int step = 0;
    int index = 0;

    // clang-tidy 14 takes the zero that a defaulted comparison compares with for a pointer.
    friend auto operator<=>(const SegmentId&, const SegmentId&) = default;  // NOLINT(modernize-use-nullptr)
};

/// Count, mean and scatter of points: all that least squares needs to know of them. Sums of two sets add up.
struct PointMoments {
    double count = 0.0;
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();     ///< [m]
    Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();  ///< Σ (p − mean)(p − mean)ᵀ [m²]

    /// Adds the points of another set (pairwise update of mean and scatter).
    PointMoments& operator+=(const PointMoments& other);

    /// Σ (n·p − d)² over the points [m²], for a unit normal n.
    double squaredDistanceTo(const Eigen::Vector3d& normal, double distance) const
    {
        const double offset = normal.dot(mean) - distance;
        return normal.dot(scatter * normal) + count * offset * offset;
    }
};

/// A line segment λ in space, Eq. (7), with what its scan points leave behind.
///
/// The end points are the raw first and last scan points in bearing order; the points between them are never read
/// again. Frame: the sensor's at its pitch axis, x right, y forward, z up, metres.
struct LineSegment {
    SegmentId id;
    int firstBeam = 0;                                          ///< beam of the start point
    int lastBeam = 0;                                           ///< beam of the end point
    int points = 0;                                             ///< scan points from start to end
    Eigen::Vector3d start = Eigen::Vector3d::Zero();            ///< u [m]
    Eigen::Vector3d end = Eigen::Vector3d::Zero();              ///< v [m]
    Eigen::Vector3d direction = Eigen::Vector3d::UnitX();       ///< δ = (u − v)/|u − v|
    Eigen::Matrix3d startCovariance = Eigen::Matrix3d::Zero();  ///< C of u, Eq. (15) [m²]
    Eigen::Matrix3d endCovariance = Eigen::Matrix3d::Zero();    ///< C of v, Eq. (15) [m²]
    Eigen::Vector3d viewpoint = Eigen::Vector3d::Zero();        ///< where the laser stood [m]
    bool startShadowed = false;   ///< beyond the start point something nearer hides whatever follows
    bool endShadowed = false;     ///< the same beyond the end point
    double directionSigma = 0.0;  ///< standard deviation of the direction in the slice [rad]
    double placeSigma = 0.0;      ///< of its mean, across the line in the slice [m]; 0 where it is not known
    double rms = 0.0;             ///< of the points about their own line [m]
    PointMoments moments;         ///< of all its points

    double length() const { return (start - end).norm(); }
    Eigen::Vector3d midpoint() const { return 0.5 * (start + end); }
};

/// Turns a segment about the origin, with all that it knows of its points.
void turn(LineSegment& segment, const Eigen::Matrix3d& rotation);

/// The line segments of one slice in bearing order.
using Segments = std::vector<LineSegment>;

}  // namespace planewright
