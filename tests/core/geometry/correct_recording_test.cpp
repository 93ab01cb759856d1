// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/geometry/correct_recording.h"

#include <QtTest>

#include "core/geometry/sensor_model.h"
#include "core/geometry/slice_corrector.h"
#include "core/types/angle.h"
#include "tests/test_program.h"

namespace planewright {

namespace {

/// Slices of four beams at these pitches [deg].
Recording recordingAt(const std::vector<double>& pitches)
{
    Recording recording;
    recording.description.rangeMin = 0.5;
    recording.description.rangeMax = 10.0;
    recording.description.pitchAxisOffset = 0.05;
    for (const double pitch : pitches) {
        ScanSlice slice;
        slice.step = static_cast<int>(recording.slices.size());
        slice.tilt = degrees(pitch);
        slice.bearingStep = degrees(1.0);
        slice.ranges = {0.0, 0.5, 2.0, 10.0};
        recording.slices.push_back(slice);
    }
    return recording;
}

bool areClose(double a, double b)
{
    return std::abs(a - b) < 1e-12;
}

}  // namespace

class CorrectRecordingTest : public QObject {
    Q_OBJECT

private slots:
    void withoutCorrectionsEveryNumberStays();
    void anOffsetMovesReturnsAndTheirLimits();
    void whatWasNoReturnStaysNone();
    void aReturnThatWouldEndBehindTheLaserIsNone();
    void theZeroTurnsBothEndsOfASweep();
    void theLeverArmGrows();
    void theSweepTurnsByItsShareOfAStep();
    void theDelayTurnsTheWayTheHeadNods();
    void ratesCountMissingSteps();
    void aSliceAloneDoesNotNod();
    void slicesComeCorrectedWhileTheyAreMeasured();
};

void CorrectRecordingTest::withoutCorrectionsEveryNumberStays()
{
    Recording recording = recordingAt({60.0, 61.0});
    recording.slices[0].ranges[2] = 0.1;  // nearer than the limit

    correctRecording(recording, {});

    QCOMPARE(recording.slices[0].ranges, (std::vector{0.0, 0.5, 0.1, 10.0}));
    QCOMPARE(recording.slices[1].tilt, degrees(61.0));
    QVERIFY(!recording.slices[0].tiltEnd);
    QCOMPARE(recording.description.pitchAxisOffset, 0.05);
}

void CorrectRecordingTest::anOffsetMovesReturnsAndTheirLimits()
{
    Recording recording = recordingAt({60.0});
    SensorParameters sensor;
    sensor.rangeOffset = 0.03;

    correctRecording(recording, sensor);

    QCOMPARE(recording.slices[0].ranges, (std::vector{0.0, 0.5 + 0.03, 2.0 + 0.03, 10.0 + 0.03}));
    QVERIFY(sensorOf(recording.description).hasEcho(recording.slices[0].ranges[1]));
    QVERIFY(sensorOf(recording.description).hasEcho(recording.slices[0].ranges[3]));
}

void CorrectRecordingTest::whatWasNoReturnStaysNone()
{
    Recording recording = recordingAt({60.0});
    recording.slices[0].ranges = {0.49, -1.0, 10.01, 3.0};
    SensorParameters sensor;
    sensor.rangeOffset = -0.03;

    correctRecording(recording, sensor);

    QCOMPARE(recording.slices[0].ranges, (std::vector{0.0, 0.0, 0.0, 3.0 - 0.03}));
}

void CorrectRecordingTest::aReturnThatWouldEndBehindTheLaserIsNone()
{
    Recording recording = recordingAt({60.0});
    SensorParameters sensor;
    sensor.rangeOffset = -0.6;

    correctRecording(recording, sensor);

    QCOMPARE(recording.slices[0].ranges[1], 0.0);
    QVERIFY(!sensorOf(recording.description).hasEcho(recording.slices[0].ranges[1]));
    QVERIFY(areClose(recording.slices[0].ranges[2], 1.4));
}

void CorrectRecordingTest::theZeroTurnsBothEndsOfASweep()
{
    Recording recording = recordingAt({60.0, 61.0});
    recording.slices[0].tiltEnd = degrees(60.5);
    SensorParameters sensor;
    sensor.pitchZero = degrees(2.0);

    correctRecording(recording, sensor);

    QVERIFY(areClose(recording.slices[0].tilt, degrees(62.0)));
    QVERIFY(areClose(*recording.slices[0].tiltEnd, degrees(62.5)));
    QVERIFY(!recording.slices[1].tiltEnd);
}

void CorrectRecordingTest::theLeverArmGrows()
{
    Recording recording = recordingAt({60.0});
    SensorParameters sensor;
    sensor.leverArmCorrection = -0.02;

    correctRecording(recording, sensor);

    QVERIFY(areClose(sensorOf(recording.description).pitchAxisOffset, 0.03));
}

void CorrectRecordingTest::theSweepTurnsByItsShareOfAStep()
{
    Recording recording = recordingAt({60.0, 61.0, 62.0});
    recording.slices[2].tiltEnd = degrees(62.25);
    SensorParameters sensor;
    sensor.sweepTurn = 0.5;

    correctRecording(recording, sensor);

    QVERIFY(areClose(recording.slices[1].tilt, degrees(61.0)));
    QVERIFY(areClose(*recording.slices[1].tiltEnd, degrees(61.5)));
    QVERIFY(areClose(*recording.slices[2].tiltEnd, degrees(62.75)));
}

void CorrectRecordingTest::theDelayTurnsTheWayTheHeadNods()
{
    Recording recording = recordingAt({60.0, 62.0, 64.0, 62.0, 60.0});
    SensorParameters sensor;
    sensor.pitchDelay = -0.5;

    correctRecording(recording, sensor);

    QVERIFY(areClose(recording.slices[1].tilt, degrees(61.0)));
    QVERIFY(areClose(recording.slices[2].tilt, degrees(64.0)));  // where the head turns back it stands still
    QVERIFY(areClose(recording.slices[3].tilt, degrees(63.0)));
}

void CorrectRecordingTest::ratesCountMissingSteps()
{
    Recording recording = recordingAt({60.0, 61.0, 64.0});
    recording.slices[2].step = 4;

    const std::vector<double> rates = noddingRates(recording.slices);

    QVERIFY(areClose(rates[0], degrees(1.0)));
    QVERIFY(areClose(rates[1], degrees(1.0)));
    QVERIFY(areClose(rates[2], degrees(1.0)));
}

void CorrectRecordingTest::aSliceAloneDoesNotNod()
{
    QCOMPARE(noddingRates(recordingAt({60.0}).slices), std::vector{0.0});
    QVERIFY(noddingRates({}).empty());
}

void CorrectRecordingTest::slicesComeCorrectedWhileTheyAreMeasured()
{
    const Recording measured = recordingAt({60.0, 61.0, 63.0});
    SensorParameters sensor;
    sensor.rangeOffset = 0.03;
    SliceCorrector atOnce{measured.description, sensor};
    sensor.sweepTurn = 0.5;
    SliceCorrector withNeighbours{measured.description, sensor};

    QVERIFY(atOnce.push(measured.slices[0]));
    QVERIFY(!atOnce.finish());
    QVERIFY(!withNeighbours.push(measured.slices[0]));
    QCOMPARE(withNeighbours.push(measured.slices[1]).value().step, 0);
    QCOMPARE(withNeighbours.push(measured.slices[2]).value().step, 1);
    QCOMPARE(withNeighbours.finish().value().step, 2);
    QVERIFY(!withNeighbours.finish());
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::CorrectRecordingTest)
#include "correct_recording_test.moc"
