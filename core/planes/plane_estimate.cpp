// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/planes/plane_estimate.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/LU>

#include "core/geometry/tangents.h"
#include "core/segments/line_piece.h"

namespace planewright {

namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

/// Derivatives of a segment's distance to the plane by the unknowns, at its centroid and along it.
struct Row {
    double first, second;            ///< by the tangent angles at the centroid; by d it is −1
    double firstSlope, secondSlope;  ///< along the line
    double distance;                 ///< at the linearisation point
    double inclination;
    double pitch;
    double pitchSlope;
};

inline Row rowOf(const PlaneInSlice& seen, const SegmentStatistics& s)
{
    return {seen.first.at(s.u, s.v),
            seen.second.at(s.u, s.v),
            seen.first.along(s.directionU, s.directionV),
            seen.second.along(s.directionU, s.directionV),
            seen.distance.at(s.u, s.v),
            seen.distance.along(s.directionU, s.directionV),
            seen.pitch.at(s.u, s.v),
            seen.pitch.along(s.directionU, s.directionV)};
}

/// Extent across the ray, in standard deviations of a range, below which it is noise that directs a segment's line.
constexpr double kDirectedSigmas = 2.0;

/// True where the points are noisier than they are apart: their line may run along the ray, and the noise across it is
/// next to none then. What the plane says of the noise across itself holds whatever the line's direction.
inline bool isDirectedByNoise(const SegmentStatistics& s, const NoiseParameters& noise)
{
    const double squaredRange = s.u * s.u + s.v * s.v;
    const double aside = s.length() * (s.u * s.directionV - s.v * s.directionU);
    const double told =
        noise.rangeConstant * noise.rangeConstant + noise.rangeProportional * noise.rangeProportional * squaredRange;
    return aside * aside < kDirectedSigmas * kDirectedSigmas * told * squaredRange;
}

/// Variances of a segment's distance to the plane at its centroid and of its slope, by the noise of its points.
struct Variances {
    double place;
    double slope;
};

inline Variances variancesOf(const PlaneInSlice& seen, const SegmentStatistics& s, const Row& row,
                             const NoiseParameters& noise)
{
    double steepness = seen.steepness;
    if (isDirectedByNoise(s, noise))
        steepness = varianceAcross(seen.distance.u, seen.distance.v, s.u, s.v, noise) /
                    varianceAcross(-s.directionV, s.directionU, s.u, s.v, noise);
    if (!noise.pitchCommon) {
        // Pitch noise of its own for each point: it adds to the variance of every point.
        const double perPoint = s.offsetInformation / s.points;
        steepness += row.pitch * row.pitch * noise.pitch * noise.pitch * perPoint;
    }
    return {steepness / s.offsetInformation, steepness / s.slopeInformation};
}

/// The same with a floor [m²] of what the segment may be off as a whole; its slope may be off as if its ends were by
/// twice the floor.
inline Variances withFloor(Variances variances, const SegmentStatistics& segment, double squaredFloor)
{
    const double length = std::max(segment.length(), 1e-6);
    return {variances.place + squaredFloor, variances.slope + 16.0 * squaredFloor / (length * length)};
}

/// Sums over the segments of a slice: information by (first, second, d), gradient, coupling with the pitch.
struct SliceSums {
    double i00 = 0.0, i01 = 0.0, i02 = 0.0, i11 = 0.0, i12 = 0.0, i22 = 0.0;
    double g0 = 0.0, g1 = 0.0, g2 = 0.0;
    double c0 = 0.0, c1 = 0.0, c2 = 0.0;
    double chi = 0.0, pitchInformation = 0.0, pitchGradient = 0.0;

    void operator+=(const SliceSums& other)
    {
        i00 += other.i00;
        i01 += other.i01;
        i02 += other.i02;
        i11 += other.i11;
        i12 += other.i12;
        i22 += other.i22;
        g0 += other.g0;
        g1 += other.g1;
        g2 += other.g2;
        c0 += other.c0;
        c1 += other.c1;
        c2 += other.c2;
        chi += other.chi;
        pitchInformation += other.pitchInformation;
        pitchGradient += other.pitchGradient;
    }
};

/// Those of one segment, which most slices have of a plane.
inline SliceSums sumsOf(const PlaneInSlice& seen, const SegmentStatistics& segment, const NoiseParameters& noise,
                        double squaredFloor)
{
    const Row row = rowOf(seen, segment);
    Variances variances = variancesOf(seen, segment, row, noise);
    if (squaredFloor > 0.0)
        variances = withFloor(variances, segment, squaredFloor);
    const double place = 1.0 / variances.place;
    const double slope = 1.0 / variances.slope;
    const double p0 = place * row.first;
    const double p1 = place * row.second;
    const double s0 = slope * row.firstSlope;
    const double s1 = slope * row.secondSlope;
    SliceSums sums;
    sums.i00 = p0 * row.first + s0 * row.firstSlope;
    sums.i01 = p0 * row.second + s0 * row.secondSlope;
    sums.i02 = -p0;
    sums.i11 = p1 * row.second + s1 * row.secondSlope;
    sums.i12 = -p1;
    sums.i22 = place;
    sums.g0 = row.distance * p0 + row.inclination * s0;
    sums.g1 = row.distance * p1 + row.inclination * s1;
    sums.g2 = -(row.distance * place);
    sums.c0 = row.pitch * p0 + row.pitchSlope * s0;
    sums.c1 = row.pitch * p1 + row.pitchSlope * s1;
    sums.c2 = -(row.pitch * place);
    sums.chi = place * row.distance * row.distance + slope * row.inclination * row.inclination;
    sums.pitchInformation = place * row.pitch * row.pitch + slope * row.pitchSlope * row.pitchSlope;
    sums.pitchGradient = place * row.pitch * row.distance + slope * row.pitchSlope * row.inclination;
    return sums;
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

PlaneEstimate PlaneEstimate::afresh() const
{
    PlaneEstimate estimate(normal_, distance_);
    estimate.covariance_ = covariance_;
    estimate.normalVariance_ = normalVariance_;
    return estimate;
}

void PlaneEstimate::accumulate(const PlaneInSlice& seen, std::span<const SegmentStatistics* const> segments,
                               const NoiseParameters& noise, double floor, double sign)
{
    SliceSums sums;
    if (!segments.empty())
        sums = sumsOf(seen, *segments.front(), noise, floor * floor);
    for (std::size_t i = 1; i < segments.size(); ++i)
        sums += sumsOf(seen, *segments[i], noise, floor * floor);
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
    const Row row = rowOf(seen, segment);
    const Variances variances =
        withFloor(variancesOf(seen, segment, row, noise), segment, floor * floor * seen.steepness);
    const double pitch = commonPitchVariance(noise);
    const double distance = row.distance + row.first * step_[0] + row.second * step_[1] - step_[2];
    const Eigen::Matrix3d& c = covariance_;
    double place = variances.place + pitch * row.pitch * row.pitch;
    if (withOwnVariance)
        place += row.first * (c(0, 0) * row.first + 2.0 * (c(0, 1) * row.second - c(0, 2))) +
                 row.second * (c(1, 1) * row.second - 2.0 * c(1, 2)) + c(2, 2);
    if (distance * distance >= limit * place)
        return kInfinite;
    const double inclination = row.inclination + row.firstSlope * step_[0] + row.secondSlope * step_[1];
    double both = pitch * row.pitch * row.pitchSlope;
    double slope = variances.slope + pitch * row.pitchSlope * row.pitchSlope;
    if (withOwnVariance) {
        const double spread0 = c(0, 0) * row.firstSlope + c(0, 1) * row.secondSlope;
        const double spread1 = c(0, 1) * row.firstSlope + c(1, 1) * row.secondSlope;
        const double spread2 = c(0, 2) * row.firstSlope + c(1, 2) * row.secondSlope;
        both += row.first * spread0 + row.second * spread1 - spread2;
        slope += row.firstSlope * spread0 + row.secondSlope * spread1;
    }
    return (slope * distance * distance - 2.0 * both * distance * inclination + place * inclination * inclination) /
           (place * slope - both * both);
}

PitchEvidence PlaneEstimate::pitchEvidence(const PlaneInSlice& seen, const SegmentStatistics& segment,
                                           const NoiseParameters& noise, double floor) const
{
    const Row row = rowOf(seen, segment);
    const Variances variances = withFloor(variancesOf(seen, segment, row, noise), segment, floor * floor);
    const double distance = row.distance + row.first * step_[0] + row.second * step_[1] - step_[2];
    const double inclination = row.inclination + row.firstSlope * step_[0] + row.secondSlope * step_[1];
    const double pitch = row.pitch / variances.place;
    const double pitchSlope = row.pitchSlope / variances.slope;
    return {pitch * row.pitch + pitchSlope * row.pitchSlope, pitch * distance + pitchSlope * inclination};
}

double mostVariance(const SegmentStatistics& segment, const Eigen::Vector3d& centroid, const NoiseParameters& noise,
                    double floor)
{
    const double squaredRange = segment.u * segment.u + segment.v * segment.v;
    const double ofPoint = noise.rangeVariance(std::sqrt(squaredRange)) + noise.bearing * noise.bearing * squaredRange;
    return std::max(1.0 / segment.offsetInformation, ofPoint / segment.points) + floor * floor +
           noise.pitch * noise.pitch * centroid.squaredNorm();
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
