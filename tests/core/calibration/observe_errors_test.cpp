// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/calibration/observe_errors.h"

#include <cmath>

#include <QtTest>

#include "tests/test_program.h"

namespace planewright {

namespace {

constexpr std::array<bool, kScannerErrors> kAll{true, true, true, true};

constexpr std::size_t at(ScannerError error)
{
    return static_cast<std::size_t>(error);
}

/// Evidence in which every error is known to this share of its useful limit, by itself.
ErrorEvidence apart(double share)
{
    ErrorEvidence evidence;
    for (int i = 0; i < kScannerErrors; ++i)
        evidence.information(i, i) = 1.0 / std::pow(share * kUsefulSigma[static_cast<std::size_t>(i)], 2);
    return evidence;
}

}  // namespace

class ObserveErrorsTest : public QObject {
    Q_OBJECT

private slots:
    void goodEvidenceGivesItsSolution();
    void noEvidenceGivesNothing();
    void errorsThatExplainTheSameAreNotObserved();
    void whatIsNotObservedMakesTheRestLessSure();
    void onlyWhatIsAskedForMoves();
};

void ObserveErrorsTest::goodEvidenceGivesItsSolution()
{
    ErrorEvidence evidence = apart(0.1);
    const ErrorVector truth{0.03, -0.02, 1.0, 0.5};
    evidence.gradient = -evidence.information * truth;

    const ObservedErrors observed = observeErrors(evidence, kAll);

    for (std::size_t i = 0; i < kScannerErrors; ++i) {
        QVERIFY(observed.errors[i].observed);
        QVERIFY(std::abs(observed.errors[i].move - truth[static_cast<int>(i)]) < 1e-12);
        QVERIFY(std::abs(observed.errors[i].sigma / (0.1 * kUsefulSigma[i]) - 1.0) < 1e-9);
    }
}

void ObserveErrorsTest::noEvidenceGivesNothing()
{
    const ObservedErrors observed = observeErrors({}, kAll);

    for (std::size_t i = 0; i < kScannerErrors; ++i) {
        QVERIFY(!observed.errors[i].observed);
        QVERIFY(std::isinf(observed.errors[i].sigma));
        QVERIFY(std::abs(std::sqrt(observed.covariance(static_cast<int>(i), static_cast<int>(i))) - kUnknownSigma[i]) <
                1e-12);
    }
}

void ObserveErrorsTest::errorsThatExplainTheSameAreNotObserved()
{
    ErrorEvidence evidence = apart(0.01);
    const int range = static_cast<int>(ScannerError::RangeOffset);
    const int arm = static_cast<int>(ScannerError::LeverArm);
    const double both = std::sqrt(evidence.information(range, range) * evidence.information(arm, arm));
    evidence.information(range, arm) = evidence.information(arm, range) = both * (1.0 - 1e-9);

    const ObservedErrors observed = observeErrors(evidence, kAll);

    QVERIFY(!observed.errors[at(ScannerError::LeverArm)].observed);
    QVERIFY(observed.errors[at(ScannerError::LeverArm)].tangled == std::vector{ScannerError::RangeOffset} ||
            observed.errors[at(ScannerError::RangeOffset)].tangled == std::vector{ScannerError::LeverArm});
    QVERIFY(observed.errors[at(ScannerError::SweepTurn)].observed);
}

void ObserveErrorsTest::whatIsNotObservedMakesTheRestLessSure()
{
    ErrorEvidence evidence = apart(0.1);
    const int range = static_cast<int>(ScannerError::RangeOffset);
    const int delay = static_cast<int>(ScannerError::PitchDelay);
    evidence.information(delay, delay) = 1.0;  // to a step by itself, and half of it shared with the range
    evidence.information(range, delay) = evidence.information(delay, range) =
        0.5 * std::sqrt(evidence.information(range, range));

    const ObservedErrors observed = observeErrors(evidence, kAll);

    // A delay of one step moves the range by half of its standard deviation.
    const double alone = 0.1 * kUsefulSigma[at(ScannerError::RangeOffset)];
    QVERIFY(!observed.errors[at(ScannerError::PitchDelay)].observed);
    QVERIFY(std::abs(observed.errors[at(ScannerError::RangeOffset)].sigma - alone * std::sqrt(1.25)) < 1e-9);
    QVERIFY(std::abs(observed.covariance(range, delay) + 0.5 * alone) < 1e-9);
}

void ObserveErrorsTest::onlyWhatIsAskedForMoves()
{
    ErrorEvidence evidence = apart(0.1);
    evidence.gradient.setConstant(10.0);

    const ObservedErrors observed = observeErrors(evidence, {false, true, false, true});

    QVERIFY(!observed.errors[at(ScannerError::RangeOffset)].observed);
    QCOMPARE(observed.errors[at(ScannerError::RangeOffset)].move, 0.0);
    QVERIFY(observed.errors[at(ScannerError::LeverArm)].move != 0.0);
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::ObserveErrorsTest)
#include "observe_errors_test.moc"
