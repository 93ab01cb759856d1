// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/planes/plane_estimate.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/LU>

#include "core/geometry/tangents.h"
#include "core/planes/plane_fit.h"
#include "core/planes/segment_formulas.h"
#include "core/segments/line_piece.h"

namespace planewright {

namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

SegmentNumbers<double> numbersOf(const SegmentStatistics& s)
{
    return {s.u, s.v, s.directionU, s.directionV, s.offsetInformation, s.slopeInformation, s.length()};
}

/// Distance, slopes and variances of a segment as a plane is seen in its slice.
struct Seen {
    SegmentRow<double> row;
    SegmentVariances<double> variances;

    Seen(const PlaneInSlice& plane, const SegmentStatistics& s, const NoiseParameters& noise)
    {
        const SegmentNumbers<double> numbers = numbersOf(s);
        takeRow(plane, numbers, row);
        double steepness = plane.steepness;
        // Where the points are noisier than they are apart their line may run along the ray, and the noise across it is
        // next to none then. What the plane says of the noise across itself holds whatever the line's direction.
        double aside = 0.0;
        double least = 0.0;
        takeExtent(numbers, noise, aside, least);
        if (aside < least)
            steepness = varianceAcross(plane.distance.u, plane.distance.v, s.u, s.v, noise) /
                        varianceAcross(-s.directionV, s.directionU, s.u, s.v, noise);
        if (!noise.pitchCommon) {
            // Pitch noise of its own for each point: it adds to the variance of every point.
            const double perPoint = s.offsetInformation / s.points;
            steepness += row.pitch * row.pitch * noise.pitch * noise.pitch * perPoint;
        }
        variances = {steepness / s.offsetInformation, steepness / s.slopeInformation};
    }
};

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

PlaneEstimate PlaneEstimate::afresh() const
{
    PlaneEstimate estimate(normal_, distance_);
    const Eigen::Matrix3d turn = betweenTangents(tangents_, estimate.tangents_);
    estimate.covariance_ = turn * covariance_ * turn.transpose();
    estimate.normalVariance_ = normalVariance_;
    return estimate;
}

SegmentSums<double> PlaneEstimate::sumsOf(const PlaneInSlice& seen, const SegmentStatistics& segment,
                                          const NoiseParameters& noise, double floor)
{
    Seen here(seen, segment, noise);
    if (floor * floor > 0.0)
        addFloor(numbersOf(segment), floor * floor, here.variances);
    SegmentSums<double> sums;
    takeSums(here.row, here.variances, sums);
    return sums;
}

void PlaneEstimate::accumulate(const PlaneInSlice& seen, std::span<const SegmentStatistics* const> segments,
                               const NoiseParameters& noise, double floor, double sign)
{
    SegmentSums<double> sums{};
    if (!segments.empty())
        sums = sumsOf(seen, *segments.front(), noise, floor);
    for (std::size_t i = 1; i < segments.size(); ++i)
        sums += sumsOf(seen, *segments[i], noise, floor);
    addSlice(sums, noise, sign);
}

/// Adds a slice's sums, or takes them away, with its pitch error eliminated.
void PlaneEstimate::addSlice(const SegmentSums<double>& sums, const NoiseParameters& noise, double sign)
{
    const auto [i00, i01, i02, i11, i12, i22, g0, g1, g2, c0, c1, c2, chi, pitchInformation, pitchGradient] = sums;
    const double variance = commonPitchVariance(noise);
    const double k = variance / (1.0 + variance * pitchInformation);
    const double k0 = k * c0;
    const double k1 = k * c1;
    const double k2 = k * c2;
    information_(0, 0) += sign * (i00 - k0 * c0);
    information_(0, 1) += sign * (i01 - k0 * c1);
    information_(0, 2) += sign * (i02 - k0 * c2);
    information_(1, 1) += sign * (i11 - k1 * c1);
    information_(1, 2) += sign * (i12 - k1 * c2);
    information_(2, 2) += sign * (i22 - k2 * c2);
    information_(1, 0) = information_(0, 1);
    information_(2, 0) = information_(0, 2);
    information_(2, 1) = information_(1, 2);
    gradient_[0] += sign * (g0 - k0 * pitchGradient);
    gradient_[1] += sign * (g1 - k1 * pitchGradient);
    gradient_[2] += sign * (g2 - k2 * pitchGradient);
    chi_ += sign * (chi - k * pitchGradient * pitchGradient);
}

void PlaneEstimate::addCommonErrors(std::span<const Eigen::Vector3d> gradients)
{
    const Eigen::Matrix3d alone = covariance_;
    for (const Eigen::Vector3d& gradient : gradients) {
        const Eigen::Vector3d moved = alone * gradient;
        covariance_ += moved * moved.transpose();
    }
    normalVariance_ = largestNormalVariance(covariance_);
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
    normalVariance_ = largestNormalVariance(inverse);
    return true;
}

double PlaneEstimate::joinChi(const PlaneInSlice& seen, const SegmentStatistics& segment, const NoiseParameters& noise,
                              double floor, double limit) const
{
    return chiOf(seen, segment, noise, floor, limit, true);
}

double PlaneEstimate::residualChi(const PlaneInSlice& seen, const SegmentStatistics& segment,
                                  const NoiseParameters& noise, double floor) const
{
    return chiOf(seen, segment, noise, floor, kInfinite, false);
}

double PlaneEstimate::chiOf(const PlaneInSlice& seen, const SegmentStatistics& segment, const NoiseParameters& noise,
                            double floor, double limit, bool withOwnVariance) const
{
    if (seen.steepness <= kLeastSteepness)
        return kInfinite;
    Seen here(seen, segment, noise);
    addFloor(numbersOf(segment), floor * floor * seen.steepness, here.variances);
    const double pitch = commonPitchVariance(noise);
    const Eigen::Matrix3d* own = withOwnVariance ? &covariance_ : nullptr;
    double distance = 0.0;
    double inclination = 0.0;
    double place = 0.0;
    double chi = 0.0;
    takeResidual(here.row, step_, distance, inclination);
    takePlaceVariance(here.row, here.variances, pitch, own, place);
    if (distance * distance >= limit * place)
        return kInfinite;
    takeChi(here.row, here.variances, pitch, own, place, distance, inclination, chi);
    return chi;
}

PitchEvidence PlaneEstimate::pitchEvidence(const PlaneInSlice& seen, const SegmentStatistics& segment,
                                           const NoiseParameters& noise, double floor) const
{
    Seen here(seen, segment, noise);
    addFloor(numbersOf(segment), floor * floor, here.variances);
    double distance = 0.0;
    double inclination = 0.0;
    PitchEvidence evidence;
    takeResidual(here.row, step_, distance, inclination);
    takeEvidence(here.row, here.variances, distance, inclination, evidence.information, evidence.gradient);
    return evidence;
}

double mostVariance(const SegmentStatistics& segment, const Eigen::Vector3d& centroid, const NoiseParameters& noise,
                    double floor)
{
    const double squaredRange = segment.u * segment.u + segment.v * segment.v;
    const double ofPoint = noise.rangeVariance(std::sqrt(squaredRange)) + noise.bearing * noise.bearing * squaredRange;
    return std::max(1.0 / segment.offsetInformation, ofPoint / segment.points) + floor * floor +
           noise.pitch * noise.pitch * centroid.squaredNorm();
}

PlaneDisparity PlaneEstimate::disparity(const PlaneEstimate& other, double floor, double extent, double scatter,
                                        double otherScatter) const
{
    const double side = normal_.dot(other.normal_) < 0.0 ? -1.0 : 1.0;
    // Both in this plane's tangents: a turn of the other's normal is one of this, seen from here.
    const Eigen::Matrix3d toHere = betweenTangents(other.tangents_, tangents_);
    Eigen::Vector3d apart;
    apart.head<2>() = tangents_.transpose() * (side * other.normal_ - normal_);
    apart[2] = side * other.distance_ - distance_;
    Eigen::Matrix3d covariance = scatter * covariance_ + otherScatter * toHere * other.covariance_ * toHere.transpose();
    const double angle = floor / std::max(extent, 1e-3);
    covariance(0, 0) += angle * angle;
    covariance(1, 1) += angle * angle;
    covariance(2, 2) += floor * floor;
    return {apart.dot(covariance.inverse() * apart), covariance.determinant()};
}

}  // namespace planewright
