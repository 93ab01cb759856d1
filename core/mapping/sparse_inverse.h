// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/SparseCore>

namespace planewright {

/// The entries of a matrix's inverse where the matrix, symmetric and positive definite, or its Cholesky factor has
/// entries (Takahashi, Fagan and Chin 1973; Erisman and Tinney 1975): enough for variances, without the rest.
class SparseInverse {
public:
    /// Only the lower half of the matrix is read.
    explicit SparseInverse(const Eigen::SparseMatrix<double>& matrix);

    /// False where the matrix is not positive definite.
    bool isThere() const { return there_; }

    /// An entry of the inverse; zero where it was not computed.
    double operator()(Eigen::Index row, Eigen::Index column) const;

private:
    bool there_ = false;
    Eigen::VectorXi place_;                ///< of a row of the matrix in the factor's order
    Eigen::SparseMatrix<double> inverse_;  ///< the lower half, in the factor's order
};

}  // namespace planewright
