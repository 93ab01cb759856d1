// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>

#include <QtTest>

#include "core/simulation/scene.h"
#include "tests/devices/nodding/emulated_scanner.h"
#include "tests/test_program.h"

namespace planewright {

/// A scan whose ranges are each the least of some steps of the laser.
class JoinedStepsTest : public QObject {
    Q_OBJECT

private slots:
    void aRangeIsTheLeastOfItsSteps();
};

namespace {

std::vector<ScanSlice> takeScan(int cluster, ScanDescription& description)
{
    EmulatedRigSetup setup;
    setup.scene = makeScene("corridor", 7).value();
    EmulatedScanner emulated{setup};
    ScanPlan plan;
    plan.mode = ScanPlan::Mode::StepAndStare;
    plan.firstPitch = degrees(60.0);
    plan.slices = 5;
    plan.cluster = cluster;
    auto scanner = emulated.open(plan);
    std::vector<ScanSlice> slices;
    if (!scanner || !(*scanner)->begin({}))
        return slices;
    description = (*scanner)->description();
    for (;;) {
        const auto slice = (*scanner)->next({});
        if (!slice || !*slice)
            return slices;
        slices.push_back(**slice);
    }
}

}  // namespace

/// The same room without errors of ranges, once with every step and once with four in one. The head stands still, so
/// that both see the same.
void JoinedStepsTest::aRangeIsTheLeastOfItsSteps()
{
    ScanDescription fine;
    ScanDescription coarse;
    const auto all = takeScan(1, fine);
    const auto joined = takeScan(4, coarse);

    QCOMPARE(all.size(), std::size_t(5));
    QCOMPARE(joined.size(), std::size_t(5));
    QCOMPARE(coarse.beams, 180);
    QVERIFY(std::abs(coarse.bearingStep - degrees(1.0)) < 1e-12);
    QVERIFY(std::abs(coarse.firstBearing - (fine.firstBearing + 1.5 * fine.bearingStep)) < 1e-12);
    for (std::size_t i = 0; i < joined.size(); ++i) {
        QCOMPARE(joined[i].ranges.size(), std::size_t(180));
        QVERIFY(std::abs(joined[i].firstBearing - coarse.firstBearing) < 1e-12);
        QVERIFY(std::abs(joined[i].tilt - all[i].tilt) < 1e-9);
        int off = 0;
        for (std::size_t range = 0; range < 180; ++range) {
            double least = 1e9;  // of those that have one
            for (std::size_t step = 4 * range; step < 4 * range + 4; ++step)
                least = all[i].ranges[step] > 0.0 ? std::min(least, all[i].ranges[step]) : least;
            off += std::abs(joined[i].ranges[range] - (least < 1e9 ? least : 0.0)) > 0.005 ? 1 : 0;
        }
        // Where within a count the head comes to rest is another each time, which moves edges and slanting walls.
        QVERIFY2(off <= 9, qPrintable(QString("%1 in slice %2").arg(off).arg(i)));
    }
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::JoinedStepsTest)
#include "joined_steps_test.moc"
