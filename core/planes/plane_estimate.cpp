// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/planes/plane_estimate.h"

#include <algorithm>
#include <cmath>

#include <Eigen/LU>

#include "core/planes/end_point_cost.h"

namespace planewright {

namespace {

/// No steepness is taken for smaller, that of 3°: to a plane that holds the slice itself every line would be exact, and
/// at that angle none can be told to belong.
constexpr double kLeastSteepness = 2.7e-3;

/// Derivatives of a segment's distance to the plane, at its centroid and along it, by the unknowns.
struct Row {
    Eigen::Vector3d place;  // at the centroid
    Eigen::Vector3d slope;  // along the line
    double distance;        // at the linearisation point
    double inclination;
    double pitchPlace;
    double pitchSlope;
};

Row rowOf(const PlaneInSlice& seen, const SegmentStatistics& s)
{
    return {{seen.first.at(s.u, s.v), seen.second.at(s.u, s.v), -1.0},
            {seen.first.along(s.directionU, s.directionV), seen.second.along(s.directionU, s.directionV), 0.0},
            seen.distance.at(s.u, s.v),
            seen.distance.along(s.directionU, s.directionV),
            seen.pitch.at(s.u, s.v),
            seen.pitch.along(s.directionU, s.directionV)};
}

SliceFunction functionOf(const Eigen::Vector3d& direction, const SliceFrame& frame)
{
    return {direction.x(), direction.dot(frame.ahead), direction.dot(frame.origin)};
}

/// Variance of the distance at the centroid relative to that of a segment by its own noise: 1 but where each point has
/// its own pitch error.
struct Weights {
    double place;
    double slope;
};

Weights weightsOf(const PlaneInSlice& seen, const SegmentStatistics& s, const Row& row, const NoiseParameters& noise)
{
    double steepness = seen.steepness;
    if (!noise.pitchCommon) {
        // Pitch noise of its own for each point: it adds to the variance of every point.
        const double perPoint = s.offsetInformation / s.points;
        steepness += row.pitchPlace * row.pitchPlace * noise.pitch * noise.pitch * perPoint;
    }
    return {s.offsetInformation / steepness, s.slopeInformation / steepness};
}

/// What a segment may be off the plane as a whole [m] where its ranges may be off together by a floor [m].
double floorAcross(const PlaneInSlice& seen, double floor)
{
    return floor * std::sqrt(seen.steepness);
}

/// What a segment's slope may be off [rad] where its ends may be off by twice the floor [m].
double slopeFloorOf(const SegmentStatistics& segment, double floor)
{
    return 4.0 * floor / std::max(segment.length(), 1e-6);
}

/// Weights with a floor [m] of what the segment may be off as a whole.
Weights flooredWeights(const Weights& weights, const SegmentStatistics& segment, double floor)
{
    const double slopeFloor = slopeFloorOf(segment, floor);
    return {1.0 / (1.0 / weights.place + floor * floor), 1.0 / (1.0 / weights.slope + slopeFloor * slopeFloor)};
}

double commonPitchVariance(const NoiseParameters& noise)
{
    return noise.pitchCommon ? noise.pitch * noise.pitch : 0.0;
}

}  // namespace

SliceFrame frameOf(double tilt, const SensorModel& sensor)
{
    const double sine = std::sin(tilt);
    const double cosine = std::cos(tilt);
    SliceFrame frame;
    frame.tilt = tilt;
    frame.ahead = {0.0, sine, -cosine};
    frame.origin = sensor.pitchAxisOffset * Eigen::Vector3d{0.0, cosine, sine};
    frame.aheadTurned = {0.0, cosine, sine};
    frame.originTurned = sensor.pitchAxisOffset * Eigen::Vector3d{0.0, -sine, cosine};
    return frame;
}

PlaneEstimate::PlaneEstimate(const Eigen::Vector3d& normal, double distance)
    : normal_(normal), distance_(distance), start_(normal), startDistance_(distance), tangents_(tangentsOf(normal))
{
}

PlaneInSlice PlaneEstimate::inSlice(const SliceFrame& frame) const
{
    PlaneInSlice seen;
    seen.distance = functionOf(start_, frame);
    seen.distance.constant -= startDistance_;
    seen.first = functionOf(tangents_.col(0), frame);
    seen.second = functionOf(tangents_.col(1), frame);
    seen.pitch = {0.0, start_.dot(frame.aheadTurned), start_.dot(frame.originTurned)};
    seen.steepness = std::max(kLeastSteepness, seen.distance.u * seen.distance.u + seen.distance.v * seen.distance.v);
    return seen;
}

void PlaneEstimate::accumulate(const PlaneInSlice& seen, std::span<const SegmentStatistics* const> segments,
                               const NoiseParameters& noise, double floor, double sign)
{
    Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
    Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
    Eigen::Vector3d coupling = Eigen::Vector3d::Zero();
    double chi = 0.0;
    double pitchInformation = 0.0;
    double pitchGradient = 0.0;
    for (const SegmentStatistics* segment : segments) {
        const Row row = rowOf(seen, *segment);
        const Weights weights = flooredWeights(weightsOf(seen, *segment, row, noise), *segment, floor);
        const Eigen::Vector3d place = weights.place * row.place;
        const Eigen::Vector3d slope = weights.slope * row.slope;
        information += place * row.place.transpose() + slope * row.slope.transpose();
        gradient += row.distance * place + row.inclination * slope;
        coupling += row.pitchPlace * place + row.pitchSlope * slope;
        chi += weights.place * row.distance * row.distance + weights.slope * row.inclination * row.inclination;
        pitchInformation +=
            weights.place * row.pitchPlace * row.pitchPlace + weights.slope * row.pitchSlope * row.pitchSlope;
        pitchGradient +=
            weights.place * row.pitchPlace * row.distance + weights.slope * row.pitchSlope * row.inclination;
    }
    const double variance = commonPitchVariance(noise);
    const double k = variance / (1.0 + variance * pitchInformation);
    information_ += sign * (information - k * coupling * coupling.transpose());
    gradient_ += sign * (gradient - k * pitchGradient * coupling);
    chi_ += sign * (chi - k * pitchGradient * pitchGradient);
}

bool PlaneEstimate::solve()
{
    Eigen::Matrix3d inverse;
    bool invertible = false;
    double determinant = 0.0;
    information_.computeInverseAndDetWithCheck(inverse, determinant, invertible, 0.0);
    if (!invertible || !(determinant > 0.0) || !(inverse(0, 0) > 0.0) || !(inverse(1, 1) > 0.0) ||
        !(inverse(2, 2) > 0.0))
        return false;
    covariance_ = inverse;
    step_ = -inverse * gradient_;
    const Eigen::Vector3d moved = start_ + tangents_ * step_.head<2>();
    const double length = moved.norm();
    normal_ = moved / length;
    distance_ = (startDistance_ + step_[2]) / length;
    const double mean = 0.5 * (inverse(0, 0) + inverse(1, 1));
    const double half = 0.5 * (inverse(0, 0) - inverse(1, 1));
    normalVariance_ = mean + std::sqrt(half * half + inverse(0, 1) * inverse(0, 1));
    return true;
}

double PlaneEstimate::joinChi(const PlaneInSlice& seen, const SegmentStatistics& segment, const NoiseParameters& noise,
                              double floor) const
{
    return chiOf(seen, segment, noise, floor, covariance_);
}

double PlaneEstimate::residualChi(const PlaneInSlice& seen, const SegmentStatistics& segment,
                                  const NoiseParameters& noise, double floor) const
{
    return chiOf(seen, segment, noise, floor, Eigen::Matrix3d::Zero());
}

double PlaneEstimate::chiOf(const PlaneInSlice& seen, const SegmentStatistics& segment, const NoiseParameters& noise,
                            double rangeFloor, const Eigen::Matrix3d& covariance) const
{
    if (seen.steepness <= kLeastSteepness)
        return std::numeric_limits<double>::infinity();
    const Row row = rowOf(seen, segment);
    const Weights weights = weightsOf(seen, segment, row, noise);
    const double distance = row.distance + row.place.dot(step_);
    const double inclination = row.inclination + row.slope.dot(step_);
    const Eigen::Vector3d spread = covariance * row.place;
    const double variance = commonPitchVariance(noise);
    const double floor = floorAcross(seen, rangeFloor);
    const double slopeFloor = slopeFloorOf(segment, floor);
    const double place =
        1.0 / weights.place + variance * row.pitchPlace * row.pitchPlace + row.place.dot(spread) + floor * floor;
    const double both = variance * row.pitchPlace * row.pitchSlope + row.slope.dot(spread);
    const double slope = 1.0 / weights.slope + variance * row.pitchSlope * row.pitchSlope +
                         row.slope.dot(covariance * row.slope) + slopeFloor * slopeFloor;
    return (slope * distance * distance - 2.0 * both * distance * inclination + place * inclination * inclination) /
           (place * slope - both * both);
}

PitchEvidence PlaneEstimate::pitchEvidence(const PlaneInSlice& seen, const SegmentStatistics& segment,
                                           const NoiseParameters& noise, double floor) const
{
    const Row row = rowOf(seen, segment);
    const Weights weights = flooredWeights(weightsOf(seen, segment, row, noise), segment, floor);
    const double distance = row.distance + row.place.dot(step_);
    const double inclination = row.inclination + row.slope.dot(step_);
    return {weights.place * row.pitchPlace * row.pitchPlace + weights.slope * row.pitchSlope * row.pitchSlope,
            weights.place * row.pitchPlace * distance + weights.slope * row.pitchSlope * inclination};
}

double PlaneEstimate::mergeChi(const PlaneEstimate& other, double floor, double extent, double scatter,
                               double otherScatter) const
{
    const double side = normal_.dot(other.normal_) < 0.0 ? -1.0 : 1.0;
    // Both in this plane's tangents: a turn of the other's normal is one of this, seen from here.
    const Eigen::Matrix2d turn = tangents_.transpose() * other.tangents_;
    Eigen::Matrix3d toHere = Eigen::Matrix3d::Zero();
    toHere.topLeftCorner<2, 2>() = turn;
    toHere(2, 2) = 1.0;
    Eigen::Vector3d apart;
    apart.head<2>() = tangents_.transpose() * (side * other.normal_ - normal_);
    apart[2] = side * other.distance_ - distance_;
    Eigen::Matrix3d covariance = scatter * covariance_ + otherScatter * toHere * other.covariance_ * toHere.transpose();
    const double angle = floor / std::max(extent, 1e-3);
    covariance(0, 0) += angle * angle;
    covariance(1, 1) += angle * angle;
    covariance(2, 2) += floor * floor;
    return apart.dot(covariance.inverse() * apart);
}

}  // namespace planewright
