// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/mapping/sparse_inverse.h"

#include <algorithm>

#include <Eigen/SparseCholesky>

namespace planewright {

SparseInverse::SparseInverse(const Eigen::SparseMatrix<double>& matrix)
{
    const Eigen::SimplicialLLT<Eigen::SparseMatrix<double>, Eigen::Lower, Eigen::AMDOrdering<int>> solved(matrix);
    if (solved.info() != Eigen::Success)
        return;
    there_ = true;
    place_ = solved.permutationP().indices();
    inverse_ = solved.matrixL().nestedExpression();

    // With A = LDLᵀ and L's diagonal 1: Z = D⁻¹L⁻¹ + (I − Lᵀ)Z, from the last column to the first. Column j needs of Z
    // only the rows of L's column j.
    using Index = Eigen::SparseMatrix<double>::StorageIndex;
    const Index n = static_cast<Index>(inverse_.cols());
    const Index* starts = inverse_.outerIndexPtr();
    const Index* rows = inverse_.innerIndexPtr();
    double* values = inverse_.valuePtr();
    Eigen::VectorXd column = Eigen::VectorXd::Zero(n);  // of L, spread out
    Eigen::VectorXd products = Eigen::VectorXd::Zero(n);
    for (Index j = n - 1; j >= 0; --j) {
        const Index diagonal = starts[j];
        const Index end = starts[j + 1];
        const double pivot = values[diagonal];
        for (Index at = diagonal + 1; at < end; ++at)
            column[rows[at]] = values[at] / pivot;
        for (Index at = diagonal + 1; at < end; ++at) {
            const Index k = rows[at];
            products[k] += values[starts[k]] * column[k];
            for (Index below = starts[k] + 1; below < starts[k + 1]; ++below) {
                products[rows[below]] += values[below] * column[k];
                products[k] += values[below] * column[rows[below]];
            }
        }
        double sum = 0.0;
        for (Index at = diagonal + 1; at < end; ++at) {
            sum += column[rows[at]] * products[rows[at]];
            values[at] = -products[rows[at]];
        }
        values[diagonal] = 1.0 / (pivot * pivot) + sum;
        for (Index at = diagonal + 1; at < end; ++at) {
            column[rows[at]] = 0.0;
            // The products reach rows that are not in this column.
            for (Index below = starts[rows[at]]; below < starts[rows[at] + 1]; ++below)
                products[rows[below]] = 0.0;
        }
    }
}

double SparseInverse::operator()(Eigen::Index row, Eigen::Index column) const
{
    const int a = place_[row];
    const int b = place_[column];
    return inverse_.coeff(std::max(a, b), std::min(a, b));
}

}  // namespace planewright
