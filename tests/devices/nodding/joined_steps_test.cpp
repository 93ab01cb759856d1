// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>
#include <functional>
#include <span>

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

/// What becomes of the ranges of four neighbouring steps.
using Joins = std::function<double(std::span<const double, 4> ranges)>;

double leastOf(std::span<const double, 4> ranges)
{
    double least = 1e9;  // of those that have one
    for (const double range : ranges)
        least = range > 0.0 ? std::min(least, range) : least;
    return least < 1e9 ? least : 0.0;
}

/// Ranges of a scan of joined steps that are not what a rule makes of those of all steps, by more than 5 mm.
int offBy(const ScanSlice& joined, const ScanSlice& all, const Joins& joins)
{
    int off = 0;
    for (std::size_t range = 0; range < joined.ranges.size(); ++range) {
        const std::span<const double, 4> steps{all.ranges.data() + 4 * range, 4};
        off += std::abs(joined.ranges[range] - joins(steps)) > 0.005 ? 1 : 0;
    }
    return off;
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
        // Where within a count the head comes to rest is another each time, which moves edges and slanting walls.
        const int off = offBy(joined[i], all[i], leastOf);
        QVERIFY2(off <= 9, qPrintable(QString("%1 in slice %2").arg(off).arg(i)));
        // Other rules show.
        const auto middle = [](std::span<const double, 4> ranges) { return 0.5 * (ranges[1] + ranges[2]); };
        const auto first = [](std::span<const double, 4> ranges) { return ranges[0]; };
        const auto greatest = [](std::span<const double, 4> ranges) { return *std::ranges::max_element(ranges); };
        for (const Joins& other : {Joins{middle}, Joins{first}, Joins{greatest}})
            QVERIFY(offBy(joined[i], all[i], other) > 5 * 9);
    }
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::JoinedStepsTest)
#include "joined_steps_test.moc"
