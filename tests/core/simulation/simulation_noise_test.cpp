// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/simulation/simulation_noise.h"

#include <QtTest/QtTest>

#include "core/types/angle.h"
#include "tests/test_program.h"

using namespace planewright;

class SimulationNoiseTest : public QObject {
    Q_OBJECT

private slots:
    void noneIsExact();
    void defaultIsTheScannersDataSheet();
    void profilesHaveTheirRangeLaws();
    void profilesHaveQuantisedAnglesAndNothingElse();
    void anUnknownNameListsTheKnownOnes();
};

void SimulationNoiseTest::noneIsExact()
{
    const SimulationNoise noise = simulationNoise("none").value();

    QCOMPARE(noise.rangeSigma(0.1), 0.0);
    QCOMPARE(noise.rangeSigma(30.0), 0.0);
    QCOMPARE(noise.bearing, 0.0);
    QCOMPARE(noise.pitch, 0.0);
    QCOMPARE(noise.dropout, 0.0);
    QVERIFY(!noise.mixedPixels);
}

void SimulationNoiseTest::defaultIsTheScannersDataSheet()
{
    const SimulationNoise noise = simulationNoise("default").value();

    // 12.8 mm at 10 m and 31 mm at 30 m.
    QVERIFY(qAbs(noise.rangeSigma(10.0) - 0.0128) < 5e-5);
    QVERIFY(qAbs(noise.rangeSigma(30.0) - 0.031) < 5e-5);
    QCOMPARE(noise.bearing, degrees(0.02));
    QCOMPARE(noise.pitch, degrees(0.084));
    QCOMPARE(noise.dropout, 0.004);
    QVERIFY(noise.mixedPixels);
}

void SimulationNoiseTest::profilesHaveTheirRangeLaws()
{
    const SimulationNoise p = simulationNoise("P").value();
    const SimulationNoise s = simulationNoise("S").value();
    const SimulationNoise a = simulationNoise("A").value();

    QVERIFY(qAbs(p.rangeSigma(10.0) - 0.030) < 1e-15);
    QVERIFY(qAbs(p.rangeSigma(2.0) - 0.006) < 1e-15);
    QCOMPARE(s.rangeSigma(9.99), 0.010);
    QCOMPARE(s.rangeSigma(10.01), 0.030);
    QCOMPARE(a.rangeSigma(9.99), 0.030);
    QCOMPARE(a.rangeSigma(10.01), 0.050);
}

void SimulationNoiseTest::profilesHaveQuantisedAnglesAndNothingElse()
{
    for (const char* name : {"P", "S", "A"}) {
        const SimulationNoise noise = simulationNoise(name).value();
        // A step of 0.25° and of 0.29° has these standard deviations: step/√12.
        QVERIFY(qAbs(toDegrees(noise.bearing) - 0.25 / std::sqrt(12.0)) < 5e-4);
        QVERIFY(qAbs(toDegrees(noise.pitch) - 0.29 / std::sqrt(12.0)) < 5e-4);
        QCOMPARE(noise.dropout, 0.0);
        QVERIFY(!noise.mixedPixels);
    }
}

void SimulationNoiseTest::anUnknownNameListsTheKnownOnes()
{
    const auto result = simulationNoise("p");

    QVERIFY(!result);
    QCOMPARE(result.error().code, ErrorCode::Usage);
    QCOMPARE(QString::fromStdString(result.error().message),
             QString("No noise profile is called 'p'. Known: none, default, P, S, A."));
    for (const std::string_view name : simulationNoiseNames())
        QVERIFY(simulationNoise(name).has_value());
}

PLANEWRIGHT_TEST(SimulationNoiseTest)
#include "simulation_noise_test.moc"
