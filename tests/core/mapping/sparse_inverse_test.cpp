// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/mapping/sparse_inverse.h"

#include <Eigen/Dense>
#include <QtTest>

#include "core/simulation/random.h"
#include "tests/test_program.h"

namespace planewright {

class SparseInverseTest : public QObject {
    Q_OBJECT

private slots:
    void itsEntriesAreThoseOfTheDenseInverse();
    void aMatrixThatIsNotPositiveHasNone();
};

/// A sparse matrix of 60 unknowns, each bound to three others.
void SparseInverseTest::itsEntriesAreThoseOfTheDenseInverse()
{
    Random random(9);
    constexpr int kSize = 60;
    Eigen::MatrixXd dense = Eigen::MatrixXd::Identity(kSize, kSize);
    for (int i = 0; i < kSize; ++i) {
        for (int n = 0; n < 3; ++n) {
            const int j = random.integer(0, kSize - 1);
            const double weight = random.uniform(0.1, 2.0);
            Eigen::VectorXd row = Eigen::VectorXd::Zero(kSize);
            row[i] += 1.0;
            row[j] -= 0.7;
            dense += weight * row * row.transpose();
        }
    }
    const Eigen::MatrixXd expected = dense.inverse();

    const SparseInverse inverse(dense.sparseView());

    QVERIFY(inverse.isThere());
    for (int i = 0; i < kSize; ++i) {
        for (int j = 0; j < kSize; ++j) {
            if (dense(i, j) != 0.0)
                QVERIFY(std::abs(inverse(i, j) - expected(i, j)) < 1e-12);
        }
    }
}

void SparseInverseTest::aMatrixThatIsNotPositiveHasNone()
{
    Eigen::Matrix2d matrix;
    matrix << 1.0, 2.0, 2.0, 1.0;

    QVERIFY(!SparseInverse(matrix.sparseView()).isThere());
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::SparseInverseTest)
#include "sparse_inverse_test.moc"
