// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cmath>
#include <vector>

#include <Eigen/Core>

#include "core/geometry/sensor_model.h"
#include "core/params/parameters.h"
#include "core/segments/beam_kernels.h"
#include "core/segments/bearing_tables.h"
#include "core/types/scan_slice.h"

namespace planewright {

/// Neighbouring scan points of a slice, by their beams, both ends included.
struct PointRun {
    int first = 0;
    int last = 0;

    int points() const { return last - first + 1; }
    friend bool operator==(const PointRun&, const PointRun&) = default;
};

/// Count, mean and covariance of points in the slice's plane.
struct SliceMoments {
    int points = 0;
    Eigen::Vector2d centroid = Eigen::Vector2d::Zero();    ///< [m]
    Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();  ///< Σ (p − centroid)(p − centroid)ᵀ / points [m²]
};

/// A straight line in the slice's plane, by total least squares.
struct SliceLine {
    int points = 0;
    Eigen::Vector2d centroid = Eigen::Vector2d::Zero();    ///< [m]
    Eigen::Vector2d direction = Eigen::Vector2d::UnitX();  ///< unit vector
    double variance = 0.0;                                 ///< mean squared distance of the points to the line [m²]

    Eigen::Vector2d normal() const { return {-direction.y(), direction.x()}; }
    double distanceTo(const Eigen::Vector2d& point) const { return std::abs(normal().dot(point - centroid)); }
};

/// The scan points of a slice in the slice's own plane: u to the right along the pitch axis, v ahead [m].
///
/// Keeps its storage from slice to slice. Sums over the beams are kept running, so that the line through any stretch of
/// points costs the same few operations.
class SlicePoints {
public:
    /// Takes in a slice; beams without a return stay, as points without echo.
    void take(const ScanSlice& slice, const SensorModel& sensor, const NoiseParameters& noise);

    int beams() const { return static_cast<int>(u_.size()); }
    bool hasEcho(int beam) const { return range_[at(beam)] > 0.0; }
    int echoes() const { return beams() == 0 ? 0 : sums_.back().count; }
    double range(int beam) const { return range_[at(beam)]; }
    Eigen::Vector2d operator[](int beam) const { return {u_[at(beam)], v_[at(beam)]}; }

    /// Echoes among the beams of a run.
    int echoesIn(const PointRun& run) const { return sums_[at(run.last) + 1].count - sums_[at(run.first)].count; }

    /// The moments of the points of a run; it must hold at least one.
    SliceMoments momentsOf(const PointRun& run) const;

    /// The total-least-squares line through the points of a run; it must hold at least two.
    SliceLine lineThrough(const PointRun& run) const;

    /// Variance of a point across a line of this normal [m²]: range noise along the ray, bearing noise across it.
    double varianceAcross(int beam, const Eigen::Vector2d& normal) const
    {
        const double u = u_[at(beam)];
        const double v = v_[at(beam)];
        const double along = normal.x() * u + normal.y() * v;
        const double across = normal.y() * u - normal.x() * v;
        return along * along * relativeRangeVariance_[at(beam)] + across * across * bearingVariance_;
    }

    double sine(int beam) const { return tables_.current().sine[at(beam)]; }
    double cosine(int beam) const { return tables_.current().cosine[at(beam)]; }

    /// The points as arrays by beam, and σ_θ² [rad²].
    BeamArraysOf<double> arrays() const { return {u_.data(), v_.data(), relativeRangeVariance_.data()}; }
    /// Range of each beam [m], 0 without echo.
    const double* ranges() const { return range_.data(); }
    double bearingVariance() const { return bearingVariance_; }

private:
    struct Sums {
        int count = 0;
        double u = 0.0, v = 0.0, uu = 0.0, uv = 0.0, vv = 0.0;
    };

    static std::size_t at(int beam) { return static_cast<std::size_t>(beam); }

    BearingTables<double> tables_;
    std::vector<double> u_, v_, range_;
    std::vector<double> relativeRangeVariance_;  ///< σ_ρ²/ρ²
    std::vector<Sums> sums_;                     ///< over the beams before, so one more than beams
    double bearingVariance_ = 0.0;
};

}  // namespace planewright
