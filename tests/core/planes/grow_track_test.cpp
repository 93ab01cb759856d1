// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>
#include <vector>

#include <QtTest>

#include "core/planes/track_stages.h"
#include "tests/core/planes/nodding_scan.h"
#include "tests/test_program.h"

namespace planewright {

class GrowTrackTest : public QObject {
    Q_OBJECT

private slots:
    void planesGrowOverAllSlicesThatSeeThem();
    void planesGrowAcrossGaps_data();
    void planesGrowAcrossGaps();
    void planesGrowToNoSegmentBesideThem();
};

void GrowTrackTest::planesGrowOverAllSlicesThatSeeThem()
{
    // Fine steps: the three first segments are far apart, and others lie between, before and after them.
    NoddingScan scan;
    scan.nod(5, {}, degrees(84.0), degrees(0.2));
    scan.nod(20, {kWall, kSideWall}, degrees(85.0), degrees(0.2));
    scan.nod(5, {}, degrees(89.0), degrees(0.2));

    seed(scan);

    QCOMPARE(scan.map.planes().size(), std::size_t{2});
    for (const PlaneTrack& plane : scan.map.planes())
        QCOMPARE(plane.members.size(), std::size_t{20});
    QVERIFY2(disagreement(scan.map).empty(), disagreement(scan.map).c_str());
    QVERIFY(apart(scan.map.plane(0).estimate, kWall) < 1e-9);
    QVERIFY(apart(scan.map.plane(1).estimate, kSideWall) < 1e-9);
}

void GrowTrackTest::planesGrowAcrossGaps_data()
{
    QTest::addColumn<int>("missing");
    QTest::addColumn<double>("tiltStep");
    QTest::addColumn<bool>("bridged");

    QTest::newRow("one slice") << 1 << 1.16 << true;
    QTest::newRow("two slices") << 2 << 1.16 << false;
    QTest::newRow("two of a fine scan") << 2 << 0.25 << true;
    QTest::newRow("three of a fine scan") << 3 << 0.25 << false;
}

void GrowTrackTest::planesGrowAcrossGaps()
{
    QFETCH(const int, missing);
    QFETCH(const double, tiltStep);
    QFETCH(const bool, bridged);
    for (const bool atTheEnd : {false, true}) {
        NoddingScan scan;
        for (int k = 0; k < 12; ++k) {
            const int fromTheEnd = atTheEnd ? 11 - k : k;
            const bool hidden = fromTheEnd >= 1 && fromTheEnd <= missing;
            scan.see(degrees(85.0 + k * tiltStep), hidden ? std::vector<Surface>{} : std::vector{kWall});
        }

        seed(scan);

        QCOMPARE(scan.map.planes().size(), std::size_t{1});
        const std::size_t visible = 12 - static_cast<std::size_t>(missing);
        QCOMPARE(scan.map.plane(0).members.size(), bridged ? visible : visible - 1);
    }
}

void GrowTrackTest::planesGrowToNoSegmentBesideThem()
{
    NoddingScan scan;
    scan.nod(4, {kWall});
    scan.see(degrees(85.0) + 4 * kTiltStep, {wallBy(330, 360, 0.1), wallBy(404, 440)});

    seed(scan);

    QVERIFY((scan.map.plane(0).members == Numbers{0, 1, 2, 3}));
    QCOMPARE(scan.map.segment(4).owner, kNoPlane);
    QCOMPARE(scan.map.segment(5).owner, kNoPlane);
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::GrowTrackTest)
#include "grow_track_test.moc"
