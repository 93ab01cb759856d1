// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/replay/replayed_recording.h"

#include <thread>

#include <QtTest>

#include "tests/devices/fake_clock.h"
#include "tests/test_program.h"

namespace planewright {

using namespace std::chrono_literals;

class ReplayedRecordingTest : public QObject {
    Q_OBJECT

private slots:
    void givesEverySliceAsItWasRecordedAndThenNone();
    void keepsToTheTimesOfTheSlices();
    void beginsAnewFromTheFirstSlice();
    void isNoScanner();
    void aStopGivesNoSliceAndLosesNone();
    void goesOnStepByStepWhilePaused();
};

namespace {

std::shared_ptr<const Recording> threeSlices()
{
    auto recording = std::make_shared<Recording>();
    recording->description.beams = 2;
    for (int i = 0; i < 3; ++i) {
        ScanSlice slice;
        slice.step = 2 * i;
        slice.time = i * 50ms;
        slice.ranges = {1.0 + i, 0.0};
        recording->slices.push_back(slice);
    }
    return recording;
}

}  // namespace

void ReplayedRecordingTest::givesEverySliceAsItWasRecordedAndThenNone()
{
    FakeClock clock;
    ReplayedRecording source{threeSlices(), "three.csv", clock, 0.0, 7};

    QVERIFY(source.begin({}));
    for (int i = 0; i < 3; ++i) {
        const auto slice = source.next({});
        QVERIFY(slice && *slice);
        QCOMPARE((*slice)->step, 2 * i);
        QCOMPARE((*slice)->ranges[0], 1.0 + i);
    }
    const auto end = source.next({});

    QVERIFY(end && !*end);
    QCOMPARE(source.plannedSlices().value(), 7);
    QCOMPARE(source.description().beams, 2);
}

void ReplayedRecordingTest::keepsToTheTimesOfTheSlices()
{
    FakeClock clock;
    ReplayedRecording source{threeSlices(), "three.csv", clock, 0.5, 3};

    while (*source.next({})) {
    }

    QVERIFY(clock.now() == 200ms);
}

void ReplayedRecordingTest::beginsAnewFromTheFirstSlice()
{
    FakeClock clock;
    ReplayedRecording source{threeSlices(), "three.csv", clock, 1.0, 3};
    while (*source.next({})) {
    }

    QVERIFY(source.begin({}));
    const auto slice = source.next({});

    QVERIFY(slice && *slice);
    QCOMPARE((*slice)->step, 0);
}

void ReplayedRecordingTest::isNoScanner()
{
    FakeClock clock;
    ReplayedRecording source{threeSlices(), "three.csv", clock, 1.0, 3};

    QVERIFY(!source.isLive());
    QVERIFY(source.stopMotion());
    QCOMPARE(source.name(), std::string("three.csv"));
}

void ReplayedRecordingTest::aStopGivesNoSliceAndLosesNone()
{
    FakeClock clock;
    ReplayedRecording source{threeSlices(), "three.csv", clock, 1.0, 3};
    std::stop_source stop;
    stop.request_stop();

    const auto stopped = source.next(stop.get_token());
    const auto slice = source.next({});

    QVERIFY(stopped && !*stopped);
    QVERIFY(slice && *slice);
    QCOMPARE((*slice)->step, 0);
}

void ReplayedRecordingTest::goesOnStepByStepWhilePaused()
{
    FakeClock clock;
    ReplayedRecording source{threeSlices(), "three.csv", clock, 1.0, 3};
    std::atomic<int> slices{0};
    QVERIFY(source.pause());
    std::jthread reading{[&](const std::stop_token& stop) {
        for (auto slice = source.next(stop); slice && *slice; slice = source.next(stop))
            ++slices;
    }};

    QVERIFY(source.step());
    QTRY_COMPARE(slices.load(), 1);
    QVERIFY(source.resume());

    QTRY_COMPARE(slices.load(), 3);
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::ReplayedRecordingTest)
#include "replayed_recording_test.moc"
