// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "core/planes/plane_estimate.h"

// Formulas of a segment against a plane, for one segment or, in the lanes of a register, for several at once: written
// once, so that both give the same bits. They are inlined into whatever function is for the processor at hand, and
// arguments are references: no register is ever passed.
#define PLANEWRIGHT_FORMULA \
    template <class Number> \
    [[gnu::always_inline]] inline

namespace planewright {

/// What the formulas read of a segment.
template <class Number>
struct SegmentNumbers {
    Number u, v;
    Number directionU, directionV;
    Number offsetInformation, slopeInformation;
    Number length;
};

/// Derivatives of a segment's distance to the plane by the unknowns, at its centroid and along it.
template <class Number>
struct SegmentRow {
    Number first, second;            ///< by the tangent angles at the centroid; by d it is −1
    Number firstSlope, secondSlope;  ///< along the line
    Number distance;                 ///< at the linearisation point
    Number inclination;
    Number pitch;
    Number pitchSlope;
};

/// Variances of a segment's distance to the plane at its centroid and of its slope, by the noise of its points.
template <class Number>
struct SegmentVariances {
    Number place;
    Number slope;
};

/// Information by (first, second, d), gradient and coupling with the pitch that a segment adds to those of its slice.
template <class Number>
struct SegmentSums {
    Number i00, i01, i02, i11, i12, i22;
    Number g0, g1, g2;
    Number c0, c1, c2;
    Number chi, pitchInformation, pitchGradient;

    void operator+=(const SegmentSums& other)
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

PLANEWRIGHT_FORMULA void takeRow(const PlaneInSliceOf<Number>& seen, const SegmentNumbers<Number>& s,
                                 SegmentRow<Number>& row)
{
    row.first = seen.first.u * s.u + seen.first.v * s.v + seen.first.constant;
    row.second = seen.second.u * s.u + seen.second.v * s.v + seen.second.constant;
    row.firstSlope = seen.first.u * s.directionU + seen.first.v * s.directionV;
    row.secondSlope = seen.second.u * s.directionU + seen.second.v * s.directionV;
    row.distance = seen.distance.u * s.u + seen.distance.v * s.v + seen.distance.constant;
    row.inclination = seen.distance.u * s.directionU + seen.distance.v * s.directionV;
    row.pitch = seen.pitch.u * s.u + seen.pitch.v * s.v + seen.pitch.constant;
    row.pitchSlope = seen.pitch.u * s.directionU + seen.pitch.v * s.directionV;
}

/// Noise directs the line where `aside` is less than `least`, both squared [m⁴]: the points are noisier than they are
/// apart.
PLANEWRIGHT_FORMULA void takeExtent(const SegmentNumbers<Number>& s, const NoiseParameters& noise, Number& aside,
                                    Number& least)
{
    const Number squaredRange = s.u * s.u + s.v * s.v;
    const Number across = s.length * (s.u * s.directionV - s.v * s.directionU);
    const Number told =
        noise.rangeConstant * noise.rangeConstant + noise.rangeProportional * noise.rangeProportional * squaredRange;
    aside = across * across;
    least = kDirectedSigmas * kDirectedSigmas * told * squaredRange;
}

/// With a floor [m²] of what the segment may be off as a whole; its slope may be off as if its ends were by twice the
/// floor.
PLANEWRIGHT_FORMULA void addFloor(const SegmentNumbers<Number>& s, const Number& squaredFloor,
                                  SegmentVariances<Number>& variances)
{
    const Number length = s.length < 1e-6 ? Number{} + 1e-6 : s.length;
    variances.place = variances.place + squaredFloor;
    variances.slope = variances.slope + 16.0 * squaredFloor / (length * length);
}

/// Distance and inclination at the estimate, a step from where it was linearised.
PLANEWRIGHT_FORMULA void takeResidual(const SegmentRow<Number>& row, const Eigen::Vector3d& step, Number& distance,
                                      Number& inclination)
{
    distance = row.distance + row.first * step[0] + row.second * step[1] - step[2];
    inclination = row.inclination + row.firstSlope * step[0] + row.secondSlope * step[1];
}

/// Variance of the distance with that of the pitch and, where a covariance is given, of the plane.
PLANEWRIGHT_FORMULA void takePlaceVariance(const SegmentRow<Number>& row, const SegmentVariances<Number>& variances,
                                           double pitch, const Eigen::Matrix3d* covariance, Number& place)
{
    place = variances.place + pitch * row.pitch * row.pitch;
    if (covariance == nullptr)
        return;
    const Eigen::Matrix3d& c = *covariance;
    place += row.first * (c(0, 0) * row.first + 2.0 * (c(0, 1) * row.second - c(0, 2))) +
             row.second * (c(1, 1) * row.second - 2.0 * c(1, 2)) + c(2, 2);
}

/// χ² of distance and inclination together.
PLANEWRIGHT_FORMULA void takeChi(const SegmentRow<Number>& row, const SegmentVariances<Number>& variances, double pitch,
                                 const Eigen::Matrix3d* covariance, const Number& place, const Number& distance,
                                 const Number& inclination, Number& chi)
{
    Number both = pitch * row.pitch * row.pitchSlope;
    Number slope = variances.slope + pitch * row.pitchSlope * row.pitchSlope;
    if (covariance != nullptr) {
        const Eigen::Matrix3d& c = *covariance;
        const Number spread0 = c(0, 0) * row.firstSlope + c(0, 1) * row.secondSlope;
        const Number spread1 = c(0, 1) * row.firstSlope + c(1, 1) * row.secondSlope;
        const Number spread2 = c(0, 2) * row.firstSlope + c(1, 2) * row.secondSlope;
        both += row.first * spread0 + row.second * spread1 - spread2;
        slope += row.firstSlope * spread0 + row.secondSlope * spread1;
    }
    chi = (slope * distance * distance - 2.0 * both * distance * inclination + place * inclination * inclination) /
          (place * slope - both * both);
}

/// What a segment tells of the pitch error of its slice.
PLANEWRIGHT_FORMULA void takeEvidence(const SegmentRow<Number>& row, const SegmentVariances<Number>& variances,
                                      const Number& distance, const Number& inclination, Number& information,
                                      Number& gradient)
{
    const Number pitch = row.pitch / variances.place;
    const Number pitchSlope = row.pitchSlope / variances.slope;
    information = pitch * row.pitch + pitchSlope * row.pitchSlope;
    gradient = pitch * distance + pitchSlope * inclination;
}

PLANEWRIGHT_FORMULA void takeSums(const SegmentRow<Number>& row, const SegmentVariances<Number>& variances,
                                  SegmentSums<Number>& sums)
{
    const Number place = 1.0 / variances.place;
    const Number slope = 1.0 / variances.slope;
    const Number p0 = place * row.first;
    const Number p1 = place * row.second;
    const Number s0 = slope * row.firstSlope;
    const Number s1 = slope * row.secondSlope;
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
}

}  // namespace planewright
