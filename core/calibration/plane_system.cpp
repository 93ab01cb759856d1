// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/calibration/plane_system.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

#include "core/calibration/robust_spread.h"
#include "core/geometry/sensor_model.h"
#include "core/geometry/tangents.h"
#include "core/types/square.h"

namespace planewright {

namespace {

/// A residual counts less beyond so many standard deviations, and no more beyond so many.
constexpr double kHuber = 3.0;
constexpr double kMostSigmas = 8.0;
/// Rays that meet a plane at a shallower angle do not tell its distance.
constexpr double kLeastCosine = 0.07;
/// Before a scan has told: how bent walls are at their rim [m].
constexpr double kBendBefore = 0.005;
/// No common wall is bent by more [m].
constexpr double kMostBend = 0.01;
/// What planes as a whole tell of their bends counts for each like so many of its own three.
constexpr double kCommonBends = 3.0;
/// What was told of the pitch noise counts like so many slices.
constexpr double kToldSlices = 8.0;
/// No segment is off its plane as a whole by more [m].
constexpr double kMostSegmentNoise = 0.1;
/// The median of the size of a standard normal deviate.
constexpr double kMedianSize = 0.6745;

}  // namespace

PlaneSystem::PlaneSystem(SeenPlanes seen) : seen_(std::move(seen))
{
    for (const SeenPlane& plane : seen_.planes) {
        PlaneState state;
        state.normal = plane.normal;
        state.distance = plane.distance;
        state.tangents = tangentsOf(plane.normal);
        state.bendSigma = kBendBefore;
        measure(state, planes_.size());
        planes_.push_back(state);
    }
    bend_ = kBendBefore;
    slices_.resize(seen_.slices.size());
    locals_.resize(seen_.segments.size());
    offsets_.assign(seen_.segments.size(), 0.0);
    means_.assign(seen_.segments.size(), 0.0);
    pitchNoise_ = seen_.noise.pitch;
    segmentNoise_ = seen_.noise.systematic;
}

/// The middle of a plane's points and how far they reach.
void PlaneSystem::measure(PlaneState& plane, std::size_t number) const
{
    double count = 0.0;
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
    const SensorModel sensor{seen_.leverArm};
    for (const SeenSlice& slice : seen_.slices) {
        const double tilt = slice.tilt + 0.5 * slice.turn;
        for (std::size_t i = slice.first; i < slice.end; ++i) {
            const SeenSegment& segment = seen_.segments[i];
            if (segment.plane != number)
                continue;
            for (std::size_t j = segment.first; j < segment.end; ++j) {
                const SeenPoint& point = seen_.points[j];
                const Eigen::Vector3d place = toCartesian(
                    point.range, BeamDirection{point.sine, point.cosine, std::sin(tilt), std::cos(tilt)}, sensor);
                count += 1.0;
                sum += place;
                squares += place * place.transpose();
            }
        }
    }
    plane.middle = sum / std::max(1.0, count);
    const Eigen::Matrix3d covariance = squares / std::max(1.0, count) - plane.middle * plane.middle.transpose();
    const Eigen::Matrix2d inPlane = plane.tangents.transpose() * covariance * plane.tangents;
    const double reach = 2.0 * std::sqrt(std::max(1e-4, inPlane.trace()));
    plane.axes = plane.tangents / reach;
}

PlaneSystem::Equations PlaneSystem::localOf(const SeenSlice& slice, double pitchError, std::size_t number)
{
    const SeenSegment& segment = seen_.segments[number];
    const PlaneState& plane = planes_[segment.plane];
    const Eigen::Vector3d& n = plane.normal;
    const double rangeOffset = errors_[static_cast<int>(ScannerError::RangeOffset)];
    const double arm = seen_.leverArm + errors_[static_cast<int>(ScannerError::LeverArm)];
    const double turn = slice.turn + errors_[static_cast<int>(ScannerError::SweepTurn)] * slice.rate;
    const double first = slice.tilt + pitchError + errors_[static_cast<int>(ScannerError::PitchDelay)] * slice.rate;

    Equations local;
    Eigen::Matrix<double, kLocal, 1> offset = Eigen::Matrix<double, kLocal, 1>::Zero();
    double weights = 0.0;
    double weighted = 0.0;
    double sinTilt = std::sin(first);
    double cosTilt = std::cos(first);
    for (std::size_t i = segment.first; i < segment.end; ++i) {
        const SeenPoint& point = seen_.points[i];
        if (turn != 0.0) {
            sinTilt = std::sin(first + turn * point.sweep);
            cosTilt = std::cos(first + turn * point.sweep);
        }
        // Of the plane along the ray, ahead in the slice, and across the slice.
        const double ahead = n.y() * sinTilt - n.z() * cosTilt;
        const double across = n.y() * cosTilt + n.z() * sinTilt;
        const double along = n.x() * point.cosine + ahead * point.sine;
        if (std::abs(along) < kLeastCosine)
            continue;
        const double flat = (plane.distance - arm * across) / along;
        if (!(flat > 0.0))
            continue;
        const Eigen::Vector3d foot{flat * point.cosine, flat * point.sine * sinTilt + arm * cosTilt,
                                   -flat * point.sine * cosTilt + arm * sinTilt};
        const Eigen::Vector2d rim = plane.axes.transpose() * (foot - plane.middle);
        const Eigen::Vector3d forms{rim.x() * rim.x(), rim.x() * rim.y(), rim.y() * rim.y()};
        const double range = flat + plane.bend.dot(forms) / along;
        if (!(range > 0.0))
            continue;
        const double residual = along * (point.range + rangeOffset - range);
        const double byBearing = range * (ahead * point.cosine - n.x() * point.sine);
        double variance =
            square(along * rangeScale_) * seen_.noise.rangeVariance(range) + square(byBearing * seen_.noise.bearing);
        const double byPitch = range * point.sine * across - arm * ahead;
        if (!seen_.noise.pitchCommon)
            variance += square(byPitch * pitchNoise_);
        variance = std::max(variance, 1e-12);
        const double size = std::abs(residual - offsets_[number]) / std::sqrt(variance);
        sizes_.push_back(size * rangeScale_);
        if (moved_ && size > kMostSigmas)
            continue;
        const double weight = std::min(1.0, kHuber / std::max(size, 1e-9)) / variance;

        const Eigen::Vector3d place{range * point.cosine, range * point.sine * sinTilt + arm * cosTilt,
                                    -range * point.sine * cosTilt + arm * sinTilt};
        Eigen::Matrix<double, kLocal, 1> row;
        row << along, across, byPitch * slice.rate * point.sweep, byPitch * slice.rate, byPitch,
            plane.tangents.col(0).dot(place), plane.tangents.col(1).dot(place), -1.0, -forms;
        local.information.noalias() += weight * row * row.transpose();
        local.gradient += weight * residual * row;
        offset += weight * row;
        weights += weight;
        weighted += weight * residual;
    }
    local.weight = weights;
    // A segment that is off as a whole counts less: it is of something else, however well its points agree.
    if (moved_ && weights > 0.0) {
        const double sigmas = std::abs(means_[number]) / std::sqrt(1.0 / weights + square(segmentNoise_));
        const double trust = sigmas > kMostSigmas ? 0.0 : std::min(1.0, kHuber / std::max(sigmas, 1e-9));
        means_[number] = weighted / weights;
        local.information *= trust;
        local.gradient *= trust;
        offset *= trust;
        weights *= trust;
        weighted *= trust;
    } else {
        means_[number] = weights > 0.0 ? weighted / weights : 0.0;
    }
    if (segmentNoise_ > 0.0) {
        const double k = 1.0 / (weights + 1.0 / square(segmentNoise_));
        local.information -= k * offset * offset.transpose();
        local.gradient -= k * weighted * offset;
        offsets_[number] = k * weighted;
    }
    return local;
}

/// Adds a slice's segments to the equations and eliminates its pitch.
void PlaneSystem::accumulate(std::size_t number)
{
    const SeenSlice& slice = seen_.slices[number];
    SliceState& state = slices_[number];
    const bool common = seen_.noise.pitchCommon && pitchNoise_ > 0.0;
    state.information = common ? 1.0 / square(pitchNoise_) : 0.0;
    state.gradient = common ? state.pitchError / square(pitchNoise_) : 0.0;
    state.coupling.setZero(information_.rows());
    for (std::size_t i = slice.first; i < slice.end; ++i) {
        Equations local = locals_[i] = localOf(slice, state.pitchError, i);
        local.information *= planes_[seen_.segments[i].plane].trust;
        local.gradient *= planes_[seen_.segments[i].plane].trust;
        const Eigen::Index plane = placeOf(seen_.segments[i].plane);
        information_.topLeftCorner<kScannerErrors, kScannerErrors>() +=
            local.information.topLeftCorner<kScannerErrors, kScannerErrors>();
        information_.block<kScannerErrors, kOfPlane>(0, plane) +=
            local.information.block<kScannerErrors, kOfPlane>(0, kPlane);
        information_.block<kOfPlane, kOfPlane>(plane, plane) +=
            local.information.block<kOfPlane, kOfPlane>(kPlane, kPlane);
        gradient_.head<kScannerErrors>() += local.gradient.head<kScannerErrors>();
        gradient_.segment<kOfPlane>(plane) += local.gradient.segment<kOfPlane>(kPlane);
        state.information += local.information(kPitch, kPitch);
        state.gradient += local.gradient[kPitch];
        state.coupling.head<kScannerErrors>() += local.information.block<kScannerErrors, 1>(0, kPitch);
        state.coupling.segment<kOfPlane>(plane) += local.information.block<kOfPlane, 1>(kPlane, kPitch);
    }
    if (!common)
        return;
    information_.noalias() -= state.coupling * state.coupling.transpose() / state.information;
    gradient_ -= state.coupling * (state.gradient / state.information);
}

ErrorEvidence PlaneSystem::linearise()
{
    if (planes_.empty())
        return {};
    const Eigen::Index unknowns = placeOf(planes_.size());
    information_.setZero(unknowns, unknowns);
    gradient_.setZero(unknowns);
    sizes_.clear();
    for (std::size_t slice = 0; slice < slices_.size(); ++slice)
        accumulate(slice);
    for (std::size_t i = 0; i < planes_.size(); ++i) {
        const double known = 1.0 / square(planes_[i].bendSigma);
        information_.diagonal().segment<3>(placeOf(i) + 3).array() += known;
        gradient_.segment<3>(placeOf(i) + 3) += known * planes_[i].bend;
    }
    // The planes' and the errors' coupling stands above the diagonal, but for what the pitch has added on both sides.
    const Eigen::Index planes = unknowns - kScannerErrors;
    const Eigen::MatrixXd coupling = information_.topRightCorner(kScannerErrors, planes).transpose();
    Eigen::MatrixXd own = information_.bottomRightCorner(planes, planes);
    own.diagonal() *= 1.0 + 1e-12;
    const Eigen::LDLT<Eigen::MatrixXd> factors(own);
    inverse_ = factors.solve(Eigen::MatrixXd::Identity(planes, planes));
    toErrors_ = factors.solve(coupling);
    planeStep_ = factors.solve(gradient_.tail(planes));
    ErrorEvidence evidence;
    evidence.information =
        information_.topLeftCorner<kScannerErrors, kScannerErrors>() - coupling.transpose() * toErrors_;
    evidence.gradient = gradient_.head<kScannerErrors>() - coupling.transpose() * planeStep_;
    return evidence;
}

void PlaneSystem::move(const ErrorVector& errors)
{
    if (planes_.empty())
        return;
    const Eigen::VectorXd step = -(planeStep_ + toErrors_ * errors);
    Eigen::VectorXd all(step.size() + kScannerErrors);
    all << errors, step;
    for (SliceState& slice : slices_) {
        if (seen_.noise.pitchCommon && pitchNoise_ > 0.0)
            slice.pitchError -= (slice.gradient + slice.coupling.dot(all)) / slice.information;
    }
    for (std::size_t i = 0; i < planes_.size(); ++i) {
        PlaneState& plane = planes_[i];
        const auto moved = step.segment<kOfPlane>(placeOf(i) - kScannerErrors);
        const Eigen::Vector3d normal = plane.normal + plane.tangents * moved.head<2>();
        plane.distance = (plane.distance + moved[2]) / normal.norm();
        plane.normal = normal.normalized();
        plane.tangents = tangentsOf(plane.normal);
        plane.bend += moved.tail<3>();
    }
    errors_ += errors;
    learnNoise();
    learnBends();
    moved_ = true;
}

/// Takes the sizes of pitch errors, segment offsets and residuals as the noise that they are drawn from.
void PlaneSystem::learnNoise()
{
    double squares = kToldSlices * square(seen_.noise.pitch);
    double slices = kToldSlices;
    for (const SliceState& slice : slices_) {
        if (slice.information * square(pitchNoise_) < 2.0)
            continue;
        squares += square(slice.pitchError) + 1.0 / slice.information;
        slices += 1.0;
    }
    pitchNoise_ = std::sqrt(squares / slices);

    rangeScale_ = std::max(1.0, medianOf(sizes_) / kMedianSize);

    std::vector<Deviation> means;
    for (std::size_t i = 0; i < means_.size(); ++i) {
        if (locals_[i].weight > 0.0)
            means.push_back({square(means_[i]), 1.0 / locals_[i].weight});
    }
    segmentNoise_ = std::max(seen_.noise.systematic, spreadOf(means, kMostSegmentNoise));
}

/// Takes the sizes of bends as those that walls have: of a common plane, and of each that has more reason to be bent.
void PlaneSystem::learnBends()
{
    std::vector<double> all;
    for (std::size_t i = 0; i < planes_.size(); ++i) {
        PlaneState& plane = planes_[i];
        const auto place = placeOf(i) - kScannerErrors + 3;
        const double squares = plane.bend.squaredNorm() + inverse_.diagonal().segment<3>(place).sum();
        all.push_back(squares / 3.0);
        plane.bendSigma = std::sqrt((kCommonBends * square(bend_) + squares) / (kCommonBends + 3.0));
    }
    bend_ = std::clamp(std::sqrt(medianOf(all)), 1e-5, kMostBend);
}

PlanesEstimate PlaneSystem::planes(const ErrorMatrix& errors) const
{
    PlanesEstimate estimate;
    if (planes_.empty())
        return estimate;
    for (const PlaneState& plane : planes_) {
        estimate.normals.push_back(plane.normal);
        estimate.tangents.push_back(plane.tangents);
    }
    const Eigen::MatrixXd covariance = inverse_ + toErrors_ * errors * toErrors_.transpose();
    const auto count = static_cast<Eigen::Index>(planes_.size());
    estimate.covariance.resize(3 * count, 3 * count);
    for (Eigen::Index i = 0; i < count; ++i) {
        for (Eigen::Index j = 0; j < count; ++j)
            estimate.covariance.block<3, 3>(3 * i, 3 * j) = covariance.block<3, 3>(kOfPlane * i, kOfPlane * j);
    }
    return estimate;
}

}  // namespace planewright
