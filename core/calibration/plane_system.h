// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "core/calibration/scanner_errors.h"
#include "core/calibration/seen_planes.h"

namespace planewright {

/// Planes with what is known of them together.
struct PlanesEstimate {
    std::vector<Eigen::Vector3d> normals;
    std::vector<Eigen::Matrix<double, 3, 2>> tangents;
    /// Of (tangent angle 1, tangent angle 2, d) of all planes one after the other [rad², rad·m, m²].
    Eigen::MatrixXd covariance;
};

/// The planes of one scan by maximum likelihood, together with the scanner's errors.
///
/// Unknown are the errors; of each plane three parameters and three of its bend, a quadratic form, because walls are
/// not flat; the pitch error of each slice; and what each segment is off its plane as a whole, because ranges err
/// together. All but errors and planes are normal about zero, with variances that the scan itself tells. Pitches and
/// segments are eliminated as they come, the planes at the end (Schur complements). A point's residual is its range
/// against the range that its plane predicts, times the cosine of the incidence, and all derivatives are those at the
/// predicted point: noise of the range enters none of them. Points that are off more than noise explains count less
/// (Huber).
class PlaneSystem {
public:
    explicit PlaneSystem(SeenPlanes seen);

    /// Linearises all residuals at the estimate and eliminates all but the scanner's errors.
    ErrorEvidence linearise();

    /// Moves to the solution where the scanner's errors move by this.
    void move(const ErrorVector& errors);

    /// After linearise(): what a plane alone says about some errors, against what all say together.
    struct Opinion {
        double chi = 0.0;     ///< χ² of the difference by its noise alone
        int freedom = 0;      ///< its degrees of freedom
        double weight = 0.0;  ///< Σ of the points' weights [1/m²]
        double trust = 1.0;   ///< that it has
    };
    std::vector<Opinion> opinions(const std::vector<int>& errors) const;

    /// Lets a plane count for this share of what its noise alone would make it.
    void setTrust(std::size_t plane, double trust);

    /// After linearise(): the planes, where the errors have this covariance.
    PlanesEstimate planes(const ErrorMatrix& errors) const;

    const SeenPlanes& seen() const { return seen_; }
    double pitchNoise() const { return pitchNoise_; }  ///< found [rad]

private:
    static constexpr int kPitch = kScannerErrors;                 // place of the pitch in a segment's equations
    static constexpr int kPlane = kScannerErrors + 1;             // place of its plane there
    static constexpr int kOfPlane = 6;                            // two tangent angles, d, bend
    static constexpr int kLocal = kScannerErrors + 1 + kOfPlane;  // errors, pitch, plane

    /// Normal equations in the errors, the pitch of a slice and one plane.
    struct Equations {
        Eigen::Matrix<double, kLocal, kLocal> information = Eigen::Matrix<double, kLocal, kLocal>::Zero();
        Eigen::Matrix<double, kLocal, 1> gradient = Eigen::Matrix<double, kLocal, 1>::Zero();
        double weight = 0.0;  // of the points, before they are trusted less as a whole [1/m²]
    };
    struct SliceState {
        double pitchError = 0.0;
        double information = 0.0;  // of the pitch, with what is known beforehand
        double gradient = 0.0;
        Eigen::VectorXd coupling;  // of the pitch with errors and planes
    };
    struct PlaneState {
        Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
        double distance = 0.0;
        Eigen::Matrix<double, 3, 2> tangents = Eigen::Matrix<double, 3, 2>::Zero();
        Eigen::Vector3d middle = Eigen::Vector3d::Zero();  // of its points [m]
        Eigen::Matrix<double, 3, 2> axes =
            Eigen::Matrix<double, 3, 2>::Zero();         // coordinates about it that are 1 at the rim [1/m]
        Eigen::Vector3d bend = Eigen::Vector3d::Zero();  // of x², xy, y² [m]
        double bendSigma = 0.0;                          // of these [m]
        double trust = 1.0;
    };

    static Eigen::Index placeOf(std::size_t plane)
    {
        return kScannerErrors + kOfPlane * static_cast<Eigen::Index>(plane);
    }

    void measure(PlaneState& plane, std::size_t number) const;
    Equations localOf(const SeenSlice& slice, double pitchError, std::size_t segment);
    void accumulate(std::size_t slice);
    Equations equationsOf(std::size_t plane) const;
    void learnNoise();
    void learnBends();

    SeenPlanes seen_;
    std::vector<PlaneState> planes_;
    std::vector<SliceState> slices_;
    std::vector<Equations> locals_;  // of the segments
    std::vector<double> offsets_;    // what each segment is off [m]
    std::vector<double> means_;      // mean residual of each segment [m]
    std::vector<double> sizes_;      // of normalised residuals
    ErrorVector errors_ = ErrorVector::Zero();
    double pitchNoise_ = 0.0;
    double segmentNoise_ = 0.0;  // what segments are off as a whole [m]
    double bend_ = 0.0;          // of a common plane, at its rim [m]
    double rangeScale_ = 1.0;    // of the ranges' standard deviation
    bool moved_ = false;

    Eigen::MatrixXd information_;  // of errors and planes
    Eigen::VectorXd gradient_;
    Eigen::MatrixXd inverse_;    // of the planes' part
    Eigen::MatrixXd toErrors_;   // of the planes by the errors: inverse · coupling
    Eigen::VectorXd planeStep_;  // with the errors where they are
};

}  // namespace planewright
