// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/session/session_parameters.h"

#include <QtTest>

#include "tests/test_program.h"

namespace planewright {

namespace {

std::shared_ptr<const Parameters> sessionParametersWith(int enoughPoints)
{
    Parameters parameters;
    parameters.likelihood.enoughPoints = enoughPoints;
    return std::make_shared<const Parameters>(parameters);
}

/// A step without measurements of a slice of this number.
ExtractedStep extractedStep(int step, std::shared_ptr<const Parameters> parameters)
{
    ScanSlice slice;
    slice.step = step;
    auto snapshot = std::make_shared<Snapshot>();
    snapshot->report.step = step;
    const auto shared = std::make_shared<const ScanSlice>(slice);
    return {shared, shared, snapshot, std::move(parameters)};
}

}  // namespace

/// What a scan is extracted with, before and after.
class SessionParametersTest : public QObject {
    Q_OBJECT

private slots:
    void whatARecordingHoldsGoesBeforeTheDefaults();
    void whatWasSetAnewHoldsFromItsStepOn();
    void aScanWithoutStepsHasNone();
};

void SessionParametersTest::whatARecordingHoldsGoesBeforeTheDefaults()
{
    const auto stored = sessionParametersWith(321);

    const auto parameters = defaultParameters("UTM-30LX", {{0, *stored}});

    QCOMPARE(parameters.size(), std::size_t(1));
    QCOMPARE(parameters[0].parameters.likelihood.enoughPoints, 321);
}

void SessionParametersTest::whatWasSetAnewHoldsFromItsStepOn()
{
    const auto first = sessionParametersWith(100);
    const auto second = sessionParametersWith(200);
    ScanHistory history{{}, 0};
    // Step 4 was lost.
    history.add({extractedStep(2, first), extractedStep(3, first), extractedStep(5, second), extractedStep(6, second)});

    const auto parameters = parametersOf(history);

    QCOMPARE(parameters.size(), std::size_t(2));
    QCOMPARE(parameters[0].step, 0);
    QCOMPARE(parameters[0].parameters.likelihood.enoughPoints, 100);
    QCOMPARE(parameters[1].step, 5);
    QCOMPARE(parameters[1].parameters.likelihood.enoughPoints, 200);
}

void SessionParametersTest::aScanWithoutStepsHasNone()
{
    QVERIFY(parametersOf(ScanHistory{}).empty());
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::SessionParametersTest)
#include "session_parameters_test.moc"
