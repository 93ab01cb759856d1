// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>

#include <Eigen/Core>

namespace planewright {

/// What planes can tell of a scanner's errors, in the order of vectors and matrices: range offset [m], lever arm [m],
/// turn of a sweep and delay of the pitch [steps from slice to slice].
///
/// The zero of the pitch is not among them: it turns the whole room about the pitch axis, and no plane is less flat.
enum class ScannerError { RangeOffset, LeverArm, SweepTurn, PitchDelay };
inline constexpr int kScannerErrors = 4;

using ErrorVector = Eigen::Matrix<double, kScannerErrors, 1>;
using ErrorMatrix = Eigen::Matrix<double, kScannerErrors, kScannerErrors>;

/// What planes tell of the errors when all else is eliminated: −2 log likelihood is Δ'HΔ + 2 g'Δ.
struct ErrorEvidence {
    ErrorMatrix information = ErrorMatrix::Zero();  ///< H
    ErrorVector gradient = ErrorVector::Zero();     ///< g

    ErrorEvidence& operator+=(const ErrorEvidence& other)
    {
        information += other.information;
        gradient += other.gradient;
        return *this;
    }
};

}  // namespace planewright
