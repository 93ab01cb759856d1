// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/common/simulation_setup.h"

#include <numbers>

#include <QtTest>

#include "tests/test_program.h"

namespace planewright {

class SimulationSetupTest : public QObject {
    Q_OBJECT

private slots:
    void theFirstSetupIsThePapersOwn();
    void aScanMayNodDown();
    void whatIsNoScanSaysWhatToGive_data();
    void whatIsNoScanSaysWhatToGive();
    void theAddressNamesSceneSeedAndSpeed();
    void longScansAreToldInMinutes();
};

void SimulationSetupTest::theFirstSetupIsThePapersOwn()
{
    const auto settings = acquisitionOf({});

    QVERIFY(settings);
    QCOMPARE(settings->slices, 137);
    QCOMPARE(settings->beams, 721);
    QVERIFY(std::abs(settings->firstTilt - std::numbers::pi / 18.0) < 1e-15);
    // 137 × 721 = 98,777; 137 × 25 ms = 3.425 s
    QCOMPARE(scanSizeText(*settings), std::string("137 steps × 721 points = 98,777 points, about 3.4 s"));
}

void SimulationSetupTest::aScanMayNodDown()
{
    const auto settings = acquisitionOf({.firstTilt = 90.0, .lastTilt = 60.0, .tiltStep = -10.0});

    QVERIFY(settings);
    QCOMPARE(settings->slices, 3);
}

void SimulationSetupTest::whatIsNoScanSaysWhatToGive_data()
{
    QTest::addColumn<QString>("part");
    QTest::addColumn<double>("tiltStep");
    QTest::addColumn<double>("lastTilt");
    QTest::addColumn<double>("bearingStep");
    QTest::newRow("no step") << "Tilt: give a step that leads" << 0.0 << 170.0 << 0.25;
    QTest::newRow("the wrong way") << "Tilt: give a step that leads" << -1.0 << 170.0 << 0.25;
    QTest::newRow("past the end") << "Tilt: give a smaller step" << 20.0 << 20.0 << 0.25;
    QTest::newRow("too many slices") << "65,536 angles" << 0.001 << 170.0 << 0.25;
    QTest::newRow("bearings fall") << "Bearing: give a step above 0" << 1.0 << 170.0 << -0.25;
    QTest::newRow("beyond a turn") << "from -360° to 360°" << 1.0 << 370.0 << 0.25;
    QTest::newRow("too many points") << "134,217,728 points" << 0.003 << 170.0 << 0.003;
}

void SimulationSetupTest::whatIsNoScanSaysWhatToGive()
{
    QFETCH(QString, part);
    QFETCH(double, tiltStep);
    QFETCH(double, lastTilt);
    QFETCH(double, bearingStep);

    const auto settings = acquisitionOf({.lastTilt = lastTilt, .tiltStep = tiltStep, .bearingStep = bearingStep});

    QVERIFY(!settings);
    const QString message = QString::fromStdString(settings.error().message);
    QVERIFY2(message.contains(part), qPrintable(message));
}

void SimulationSetupTest::theAddressNamesSceneSeedAndSpeed()
{
    QCOMPARE(addressOf({.scene = "office", .seed = 18446744073709551615U, .speed = 0.25}),
             std::string("sim:office?seed=18446744073709551615&speed=0.25"));
    QCOMPARE(addressOf({.speed = 0.0}), std::string("sim:corridor?seed=1&speed=0"));
}

void SimulationSetupTest::longScansAreToldInMinutes()
{
    AcquisitionSettings settings;
    settings.slices = 7200;  // × 25 ms = 180 s
    settings.beams = 1;

    QCOMPARE(scanSizeText(settings), std::string("7,200 steps × 1 points = 7,200 points, about 3.0 min"));
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::SimulationSetupTest)
#include "simulation_setup_test.moc"
