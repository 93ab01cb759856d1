// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <QtTest>

#include "core/simulation/nodding_scanner.h"
#include "tests/devices/nodding/emulated_scanner.h"
#include "tests/devices/nodding/same_planes.h"
#include "tests/test_program.h"

namespace planewright {

/// The planes of a scan that came through drivers and emulated devices, byte by byte, are those of the simulator.
class WholeScanTest : public QObject {
    Q_OBJECT

private slots:
    void itsPlanesAreThoseOfTheSimulator_data();
    void itsPlanesAreThoseOfTheSimulator();
};

namespace {

using Tilt = EmulatedRigSetup::Tilt;
using Mode = ScanPlan::Mode;

constexpr int kLarge = 3000;  ///< points of a plane that is compared

}  // namespace

void WholeScanTest::itsPlanesAreThoseOfTheSimulator_data()
{
    QTest::addColumn<Tilt>("tilt");
    QTest::addColumn<Mode>("mode");
    QTest::newRow("servo, sweeping") << Tilt::Servo << Mode::Continuous;
    QTest::newRow("servo, stepping") << Tilt::Servo << Mode::StepAndStare;
    QTest::newRow("board, sweeping") << Tilt::Board << Mode::Continuous;
    QTest::newRow("board, stepping") << Tilt::Board << Mode::StepAndStare;
}

void WholeScanTest::itsPlanesAreThoseOfTheSimulator()
{
    QFETCH(Tilt, tilt);
    QFETCH(Mode, mode);
    EmulatedRigSetup setup;
    setup.scene = makeScene("corridor", 7).value();
    setup.noise = simulationNoise("default").value();
    setup.tilt = tilt;
    EmulatedScanner emulated(setup);
    ScanPlan plan;  // Table VIII
    plan.mode = mode;
    const auto source = emulated.open(plan);
    QVERIFY2(source.has_value(), source ? "" : source.error().message.c_str());
    QVERIFY((*source)->begin({}).has_value());
    std::vector<ScanSlice> slices;
    for (auto slice = (*source)->next({}); slice && *slice; slice = (*source)->next({}))
        slices.push_back(**slice);
    QCOMPARE(slices.size(), std::size_t(137));
    const SimulatedScan simulated = simulate(setup.scene, AcquisitionSettings{}, setup.noise, 1);

    const std::vector<Plane> planes = planesOf((*source)->description(), slices);
    const std::vector<Plane> expected = planesOf(simulated.recording.description, simulated.recording.slices);

    verifySamePlanes(planes, expected, kLarge, 4);
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::WholeScanTest)
#include "whole_scan_test.moc"
