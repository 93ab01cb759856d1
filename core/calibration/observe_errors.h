// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <vector>

#include "core/calibration/scanner_errors.h"

namespace planewright {

/// An error is observed where its standard deviation is below this [m, m, steps, steps].
inline constexpr std::array<double, kScannerErrors> kUsefulSigma{0.02, 0.01, 0.25, 0.25};
/// What an error that is not observed may be: a standard deviation that the others answer for.
inline constexpr std::array<double, kScannerErrors> kUnknownSigma{0.03, 0.01, 1.0, 1.0};

/// The errors that evidence tells, and those that it does not.
struct ObservedErrors {
    struct One {
        bool observed = false;
        double move = 0.0;   ///< from where it was linearised; 0 if not observed
        double sigma = 0.0;  ///< standard deviation; if not observed, of what was looked for, or infinite
        std::vector<ScannerError> tangled;  ///< not observed because these would explain the same
    };
    std::array<One, kScannerErrors> errors;
    /// Of all: those not observed with what they may be, which the others answer for.
    ErrorMatrix covariance = ErrorMatrix::Zero();
};

/// Solves for the errors that are observed; the others stay where they are.
///
/// Those that evidence does not tell, even with all others known, are left out first. Then the worst known of the rest
/// is left out until each is known better than its useful limit; what is left out may be as large as kUnknownSigma,
/// and the uncertainties of the rest say so. Errors that are not `asked` for are left out from the start.
ObservedErrors observeErrors(const ErrorEvidence& evidence, const std::array<bool, kScannerErrors>& asked);

}  // namespace planewright
