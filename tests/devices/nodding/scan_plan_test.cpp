// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/nodding/scan_plan.h"

#include <QtTest>

#include "tests/devices/nodding/still_unit.h"
#include "tests/test_program.h"

using namespace std::chrono_literals;

namespace planewright {

class ScanPlanTest : public QObject {
    Q_OBJECT

private slots:
    void theScanOfTable8IsTakenAsItIs();
    void joinedStepsGiveFewerRangesFartherApart();
    void steppingTakesMoveRestAndTurnInWholeTurns();
    void aWideStepTakesSeveralTurns();
    void aSweepHasASpeedThatTheUnitHas_data();
    void aSweepHasASpeedThatTheUnitHas();
    void aSweepThatTheUnitCannotDoSoSlowlyIsRefused();
    void whatTheDevicesCannotDoIsSaid_data();
    void whatTheDevicesCannotDoIsSaid();
};

void ScanPlanTest::theScanOfTable8IsTakenAsItIs()
{
    const auto fitted = fitPlan({}, utm30lx(), StillUnit());

    QVERIFY2(fitted.has_value(), fitted ? "" : fitted.error().message.c_str());
    QCOMPARE(fitted->steps.first, 180);  // 90 degrees to the right of step 540, four steps a degree
    QCOMPARE(fitted->steps.last, 900);
    QCOMPARE(fitted->beams, 721);
    QCOMPARE(fitted->turnsPerSlice, 1);
    QCOMPARE(fitted->points, 98777.0);
    QVERIFY(std::abs(fitted->sweepSpeed - degrees(1.16) / 0.025) < 1e-12);
    QVERIFY(std::abs(fitted->time.count() - 137 * 0.025) < 1e-12);
}

void ScanPlanTest::joinedStepsGiveFewerRangesFartherApart()
{
    ScanPlan plan;
    plan.cluster = 4;

    const auto fitted = fitPlan(plan, utm30lx(), StillUnit());

    QVERIFY(fitted.has_value());
    QCOMPARE(fitted->steps.first, 180);
    QCOMPARE(fitted->steps.last, 899);  // the 721st step would be a cluster alone
    QCOMPARE(fitted->steps.cluster, 4);
    QCOMPARE(fitted->beams, 180);
    QCOMPARE(fitted->points, 180.0 * 137);
    QVERIFY(std::abs(fitted->bearingStep - degrees(1.0)) < 1e-12);
    QVERIFY(std::abs(fitted->firstBearing - degrees(0.375)) < 1e-12);  // the middle of 0°, 0.25°, 0.5° and 0.75°
}

void ScanPlanTest::steppingTakesMoveRestAndTurnInWholeTurns()
{
    ScanPlan plan;
    plan.mode = ScanPlan::Mode::StepAndStare;
    plan.slices = 10;
    plan.pitchStep = degrees(2.0);
    plan.travelSpeed = degrees(200.0);  // faster than the unit may: 100 degrees a second
    plan.settle = 10ms;

    const auto fitted = fitPlan(plan, utm30lx(), StillUnit());

    QVERIFY(fitted.has_value());
    QCOMPARE(fitted->sweepSpeed, 0.0);
    QVERIFY(std::abs(fitted->time.count() - 10 * 0.075) < 1e-12);
}

void ScanPlanTest::aWideStepTakesSeveralTurns()
{
    ScanPlan plan;
    plan.pitchStep = degrees(6.0);  // 240 degrees a second in one turn: the unit may do 100
    plan.slices = 20;

    const auto fitted = fitPlan(plan, utm30lx(), StillUnit());

    QVERIFY(fitted.has_value());
    QCOMPARE(fitted->turnsPerSlice, 3);
    QVERIFY(std::abs(fitted->sweepSpeed - degrees(80.0)) < 1e-12);
    QVERIFY(std::abs(fitted->time.count() - 1.5) < 1e-12);
}

namespace {

/// A unit whose speeds are whole degrees a second.
class CoarseUnit : public StillUnit {
public:
    double speedStep() const override { return degrees(1.0); }
};

}  // namespace

void ScanPlanTest::aSweepHasASpeedThatTheUnitHas_data()
{
    QTest::addColumn<double>("first");
    QTest::addColumn<double>("wanted");
    QTest::addColumn<double>("speed");
    QTest::newRow("rounded up") << 10.0 << 1.165 << 47.0;   // 46.6
    QTest::newRow("rounded down") << 10.0 << 1.16 << 46.0;  // 46.4
    QTest::newRow("downwards") << 179.0 << -1.165 << 47.0;
    QTest::newRow("to the limit") << 15.0 << 1.165 << 46.0;  // 47 would end at 180.7, above 180
    QTest::newRow("the fastest") << 10.0 << 1.0 << 40.0;
}

void ScanPlanTest::aSweepHasASpeedThatTheUnitHas()
{
    QFETCH(double, first);
    QFETCH(double, wanted);
    QFETCH(double, speed);
    ScanPlan plan;
    plan.firstPitch = degrees(first);
    plan.pitchStep = degrees(wanted);
    plan.slices = 142;

    const auto fitted = fitPlan(plan, utm30lx(), CoarseUnit());

    QVERIFY2(fitted.has_value(), fitted ? "" : fitted.error().message.c_str());
    QVERIFY(std::abs(fitted->sweepSpeed - degrees(speed)) < 1e-9);
    QVERIFY(std::abs(fitted->pitchStep - std::copysign(degrees(speed) * 0.025, wanted)) < 1e-9);
}

void ScanPlanTest::aSweepThatTheUnitCannotDoSoSlowlyIsRefused()
{
    ScanPlan plan;
    plan.pitchStep = degrees(0.03);  // 1.2 degrees a second; 1 makes steps of 0.025

    const auto refused = fitPlan(plan, utm30lx(), CoarseUnit());
    plan.mode = ScanPlan::Mode::StepAndStare;
    const auto stepping = fitPlan(plan, utm30lx(), CoarseUnit());

    QVERIFY(!refused);
    QCOMPARE(refused.error().code, ErrorCode::Usage);
    QVERIFY2(QString::fromStdString(refused.error().message).contains("a step of 0.025°"),
             refused.error().message.c_str());
    QVERIFY(stepping.has_value());
    QVERIFY(std::abs(stepping->pitchStep - degrees(0.03)) < 1e-12);
}

void ScanPlanTest::whatTheDevicesCannotDoIsSaid_data()
{
    QTest::addColumn<ScanPlan>("plan");
    QTest::addColumn<QString>("word");
    const auto row = [](const char* name, const char* word, const auto& change) {
        ScanPlan plan;
        change(plan);
        QTest::newRow(name) << plan << QString(word);
    };

    row("no slices", "1 to 65536", [](ScanPlan& p) { p.slices = 0; });
    row("too many slices", "1 to 65536", [](ScanPlan& p) { p.slices = 65537; });
    row("no step", "must not be 0", [](ScanPlan& p) { p.pitchStep = 0.0; });
    row("no travel speed", "travel speed", [](ScanPlan& p) { p.travelSpeed = 0.0; });
    row("step is no number", "must not be 0", [](ScanPlan& p) { p.pitchStep = std::nan(""); });
    row("backwards", "or before it begins", [](ScanPlan& p) { p.lastBearing = p.firstBearing; });
    row("beyond the laser's right", "sees from -45° to 225°", [](ScanPlan& p) { p.firstBearing = degrees(-50.0); });
    row("beyond the laser's left", "sees from -45° to 225°", [](ScanPlan& p) { p.lastBearing = degrees(226.0); });
    row("no cluster", "1 to 99", [](ScanPlan& p) { p.cluster = 0; });
    row("a cluster too large", "1 to 99", [](ScanPlan& p) { p.cluster = 100; });
    row("fewer than two clusters", "fewer than two ranges", [](ScanPlan& p) {
        p.cluster = 99;
        p.lastBearing = degrees(45.0);
    });
    row("above the unit", "from 0° to 180°", [](ScanPlan& p) { p.slices = 160; });
    row("below the unit", "from 0° to 180°", [](ScanPlan& p) { p.firstPitch = degrees(-1.0); });
}

void ScanPlanTest::whatTheDevicesCannotDoIsSaid()
{
    QFETCH(ScanPlan, plan);
    QFETCH(QString, word);

    const auto fitted = fitPlan(plan, utm30lx(), StillUnit());

    QVERIFY(!fitted.has_value());
    QCOMPARE(fitted.error().code, ErrorCode::Usage);
    QVERIFY2(QString::fromStdString(fitted.error().message).contains(word), fitted.error().message.c_str());
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::ScanPlanTest)
#include "scan_plan_test.moc"
