// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/nodding/tilt_track.h"

#include <QtTest>

#include "tests/test_program.h"

using namespace std::chrono_literals;

namespace planewright {

class TiltTrackTest : public QObject {
    Q_OBJECT

private slots:
    void anAngleLiesOnTheLineBetweenItsSamples();
    void noAngleIsMadeUpOutsideOfTheSamples();
    void noAngleIsMadeUpInAGap();
    void aLineAveragesWhatCountsRoundOff();
    void aLineTellsOfAHeadThatChangesItsSpeed();
    void theSkewIsTheDistanceOfTheNearerSample();
    void theMeanIsOfTheSamplesWithinOnly();
    void aHeadRestsFromWhereItStaysNearItsLastAngle();
    void samplesThatGoBackAreLeftOut();
    void samplesOfSecondsAgoAreForgotten();
};

namespace {

TiltTrack trackOf(std::initializer_list<TiltSample> samples)
{
    TiltTrack track;
    for (const TiltSample& sample : samples)
        track.add(sample);
    return track;
}

}  // namespace

void TiltTrackTest::anAngleLiesOnTheLineBetweenItsSamples()
{
    const TiltTrack track = trackOf({{10ms, 1.0, true}, {20ms, 2.0, true}, {24ms, 2.0, true}});

    QCOMPARE(track.pitchAt(10ms, 5ms).value(), 1.0);
    QCOMPARE(track.pitchAt(15ms, 5ms).value(), 1.5);
    QCOMPARE(track.pitchAt(18ms, 5ms).value(), 1.8);
    QCOMPARE(track.pitchAt(22ms, 5ms).value(), 2.0);
    QCOMPARE(track.pitchAt(24ms, 5ms).value(), 2.0);
}

void TiltTrackTest::noAngleIsMadeUpOutsideOfTheSamples()
{
    const TiltTrack track = trackOf({{10ms, 1.0, true}, {20ms, 2.0, true}});

    QVERIFY(!track.pitchAt(9ms, 5ms));
    QVERIFY(!track.pitchAt(21ms, 5ms));
    QVERIFY(!TiltTrack{}.pitchAt(0ms, 5ms));
}

void TiltTrackTest::noAngleIsMadeUpInAGap()
{
    const TiltTrack track = trackOf({{0ms, 1.0, true}, {100ms, 2.0, true}});

    QVERIFY(track.pitchAt(5ms, 5ms));
    QVERIFY(!track.pitchAt(6ms, 5ms));
    QVERIFY(!track.pitchAt(50ms, 5ms));
    QVERIFY(track.pitchAt(95ms, 5ms));
}

void TiltTrackTest::aLineAveragesWhatCountsRoundOff()
{
    TiltTrack track;
    for (int i = 0; i < 25; ++i) {  // 8 rad a second, in counts of 0.01 rad
        const double pitch = 1.0 + 8.0 * 0.004 * i;
        track.add({i * 4ms, std::round(pitch / 0.01) * 0.01, true});
    }

    const auto line = track.lineSince(0ms);

    QVERIFY(line);
    QVERIFY(std::abs(line->speed - 8.0) < 0.04);
    QVERIFY(std::abs(line->pitchAt(50ms) - 1.4) < 0.001);
    QVERIFY(line->residual < 0.0075);
    QVERIFY(!track.lineSince(90ms));
}

void TiltTrackTest::aLineTellsOfAHeadThatChangesItsSpeed()
{
    const TiltTrack track = trackOf({{0ms, 1.0, true}, {10ms, 1.1, true}, {20ms, 1.2, true}, {30ms, 1.2, true}});

    // By hand: mean 1.125 at 15 ms, slope 0.0035 / 0.0005 = 7 a second; residuals -0.02, 0.01, 0.04, -0.03.
    const auto line = track.lineSince(0ms);

    QVERIFY(line);
    QVERIFY(std::abs(line->speed - 7.0) < 1e-9);
    QVERIFY(std::abs(line->residual - 0.04) < 1e-9);
}

void TiltTrackTest::theSkewIsTheDistanceOfTheNearerSample()
{
    const TiltTrack track = trackOf({{10ms, 1.0, true}, {20ms, 2.0, true}});

    QCOMPARE(track.skewAt(13ms), TiltTrack::Time(3ms));
    QCOMPARE(track.skewAt(16ms), TiltTrack::Time(4ms));
    QCOMPARE(track.skewAt(20ms), TiltTrack::Time(0ms));
}

void TiltTrackTest::theMeanIsOfTheSamplesWithinOnly()
{
    const TiltTrack track = trackOf({{10ms, 9.0, false}, {20ms, 1.0, false}, {30ms, 2.0, false}, {40ms, 9.0, false}});

    QCOMPARE(track.meanPitch(20ms, 30ms).value(), 1.5);
    QVERIFY(!track.meanPitch(21ms, 29ms));
}

void TiltTrackTest::aHeadRestsFromWhereItStaysNearItsLastAngle()
{
    const TiltTrack track =
        trackOf({{10ms, 1.0, true}, {20ms, 1.05, true}, {30ms, 1.0, true}, {40ms, 0.99, false}, {50ms, 1.01, false}});

    QCOMPARE(track.restsSince(0.025, 3).value(), TiltTrack::Time(30ms));
    QVERIFY(!track.restsSince(0.025, 4));
    QCOMPARE(track.restsSince(0.045, 5).value(), TiltTrack::Time(10ms));
}

void TiltTrackTest::samplesThatGoBackAreLeftOut()
{
    const TiltTrack track = trackOf({{20ms, 1.0, true}, {10ms, 7.0, true}, {20ms, 8.0, true}, {30ms, 2.0, true}});

    QCOMPARE(track.pitchAt(25ms, 5ms).value(), 1.5);
    QVERIFY(!track.pitchAt(10ms, 5ms));
}

void TiltTrackTest::samplesOfSecondsAgoAreForgotten()
{
    TiltTrack track;
    for (int sample = 0; sample <= 4000; ++sample)
        track.add({sample * 1ms, 0.001 * sample, true});

    QVERIFY(!track.pitchAt(500ms, 5ms));
    QCOMPARE(track.pitchAt(2000ms, 5ms).value(), 2.0);
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::TiltTrackTest)
#include "tilt_track_test.moc"
