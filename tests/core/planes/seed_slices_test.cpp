// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>
#include <vector>

#include <QtTest>

#include "core/planes/track_stages.h"
#include "tests/core/planes/nodding_scan.h"
#include "tests/test_program.h"

namespace planewright {

class SeedSlicesTest : public QObject {
    Q_OBJECT

private slots:
    void slicesOfAHypothesisAreFarEnoughApartForThePitch_data();
    void slicesOfAHypothesisAreFarEnoughApartForThePitch();
    void slicesTooNearForThePitchAreNoSecondChoice();
    void aHeadThatRestsMakesNoPlane();
    void slicesTooNearToTellTheirPlaneGiveWayToFarther();
    void slicesOfANearSurfaceAreFarEnoughApartForItsScanner();
};

void SeedSlicesTest::slicesOfAHypothesisAreFarEnoughApartForThePitch_data()
{
    QTest::addColumn<double>("pitchSigma");
    QTest::addColumn<int>("slices");

    // Slices 0.1° apart; two standard deviations of the pitch lie between those of a hypothesis.
    QTest::newRow("0.04 degrees: each slice") << 0.04 << 1;
    QTest::newRow("0.12 degrees: each third") << 0.12 << 3;
    QTest::newRow("0.32 degrees: each seventh") << 0.32 << 7;
    QTest::newRow("0.72 degrees: each fifteenth") << 0.72 << 15;
}

void SeedSlicesTest::slicesOfAHypothesisAreFarEnoughApartForThePitch()
{
    QFETCH(const double, pitchSigma);
    QFETCH(const int, slices);
    NoddingScan scan;
    scan.parameters.noise.pitch = degrees(pitchSigma);
    scan.parameters.likelihood.seedAngle = degrees(45.0);
    scan.nod(2 * slices + 1, {kWall}, degrees(85.0), degrees(0.1));

    seed(scan);

    const auto fits = scan.recorded.decisions(DecisionKind::Fit);
    QCOMPARE(fits.size(), std::size_t{1});
    QVERIFY((stepsOf(fits[0]) == std::vector<int>{0, slices, 2 * slices}));
    // One slice less is not enough.
    NoddingScan fewer = scan;
    fewer.map = {};
    fewer.nod(2 * slices, {kWall}, degrees(85.0), degrees(0.1));
    seed(fewer);
    QVERIFY(fewer.map.planes().empty());
}

void SeedSlicesTest::slicesTooNearForThePitchAreNoSecondChoice()
{
    // Slices 0.51° apart where the pitch is known to 0.7°: each third counts, and those are on no plane.
    NoddingScan scan;
    scan.parameters.noise.pitch = degrees(0.7);
    scan.parameters.likelihood.seedAngle = degrees(45.0);
    scan.nod(7, {kWall}, degrees(85.0), degrees(0.51));
    for (SegmentNumber number = 0; number < 4; ++number)
        disturb(scan.map.segment(number).statistics, 0.0, degrees(5.0 * number));

    seed(scan);

    QVERIFY(scan.map.planes().empty());
}

void SeedSlicesTest::aHeadThatRestsMakesNoPlane()
{
    NoddingScan scan;
    scan.nod(100, {kWall}, degrees(85.0), 0.0);

    seed(scan);

    QVERIFY(scan.map.planes().empty());
}

void SeedSlicesTest::slicesTooNearToTellTheirPlaneGiveWayToFarther()
{
    // Slices 0.2° apart, a little more than twice the pitch's sigma; far off, three of them tell no normal to 3°.
    NoddingScan scan;
    scan.parameters.likelihood.seedAngle = degrees(3.0);
    scan.nod(9, {kWall}, degrees(85.0), degrees(0.2));
    const auto sigma = [&](const Numbers& members) {
        return std::sqrt(
            solvedFrom(PlaneEstimate(kWall.normal, kWall.distance), members, scan.map, scan.parameters.noise, 0.0)
                .normalVariance());
    };
    QVERIFY(sigma({0, 1, 2}) > scan.parameters.likelihood.seedAngle);
    QVERIFY(sigma({0, 3, 6}) < scan.parameters.likelihood.seedAngle);

    seed(scan);

    // Half a degree is next: three slices of 0.2°.
    const auto fits = scan.recorded.decisions(DecisionKind::Fit);
    QCOMPARE(fits.size(), std::size_t{1});
    QVERIFY((stepsOf(fits[0]) == std::vector<int>{0, 3, 6}));
    QCOMPARE(scan.map.plane(0).members.size(), std::size_t{9});
}

void SeedSlicesTest::slicesOfANearSurfaceAreFarEnoughApartForItsScanner()
{
    // A table top 0.15 m below, met 0.2 m away: slices 0.6° apart cut it 3 mm apart, no more than ranges are off
    // together. Twice that, twice, and at the angle of incidence, turns a plane across l by √2·2·3 mm·sin 45°/l.
    const Surface top{-Eigen::Vector3d::UnitZ(), 0.15, 300, 420};
    for (const double systematic : {0.0, 0.003}) {
        NoddingScan scan;
        scan.parameters.noise.systematic = systematic;
        scan.parameters.noise.rangeConstant = 0.002;
        scan.nod(60, {top}, degrees(30.0), degrees(0.6));

        seed(scan);

        QVERIFY(!scan.map.planes().empty());
        QVERIFY(apart(scan.map.planes().front().estimate, top) < 1e-6);
        const std::vector<int> steps = stepsOf(scan.recorded.decisions(DecisionKind::Fit).at(0));
        QCOMPARE(steps.size(), std::size_t{3});
        const auto middle = [&](int step) {
            const SegmentStatistics& s = scan.map.segment(step).statistics;
            return scan.map.slice(step).frame.pointAt(s.u, s.v);
        };
        const double lever = (middle(steps[2]) - middle(steps[0])).norm();
        const double incidence = scan.map.incidence(steps[2], scan.map.planes().front().estimate);
        QVERIFY(std::sqrt(2.0) * 2.0 * systematic * incidence / lever < scan.parameters.likelihood.seedAngle);
        QCOMPARE(steps[2] - steps[0] > 4, systematic > 0.0);
    }
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::SeedSlicesTest)
#include "seed_slices_test.moc"
