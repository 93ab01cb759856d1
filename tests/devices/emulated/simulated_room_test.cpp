// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/emulated/simulated_room.h"

#include <thread>

#include <QtTest>

#include "core/simulation/nodding_scanner.h"
#include "tests/devices/fake_clock.h"
#include "tests/test_program.h"

namespace planewright {

using namespace std::chrono_literals;

class SimulatedRoomTest : public QObject {
    Q_OBJECT

private slots:
    void itsSlicesAreThoseOfTheSimulationWhateverThePace();
    void takesFortySlicesASecond();
    void theNextScanIsTheSame();
    void itsHeadStandsStillAfterStopMotion();
    void isAScanner();
};

namespace {

SimulatedScanner quickScanner(double speed)
{
    SimulatedScanner scanner;
    scanner.settings.slices = 5;
    scanner.settings.bearingStep = degrees(5.0);
    scanner.settings.beams = 37;
    scanner.noise = *simulationNoise("default");
    scanner.seed = 7;
    scanner.speed = speed;
    return scanner;
}

Scene corridor()
{
    return *makeScene("corridor", 7);
}

std::vector<ScanSlice> allSlices(ScanSource& source)
{
    std::vector<ScanSlice> slices;
    while (auto slice = *source.next({}))
        slices.push_back(std::move(*slice));
    return slices;
}

}  // namespace

void SimulatedRoomTest::itsSlicesAreThoseOfTheSimulationWhateverThePace()
{
    const SimulatedScan scan =
        simulate(corridor(), quickScanner(1.0).settings, quickScanner(1.0).noise, quickScanner(1.0).seed);
    for (const double speed : {0.0, 1.0, 3.0}) {
        FakeClock clock;
        SimulatedRoom room{corridor(), quickScanner(speed), clock};

        const std::vector<ScanSlice> slices = allSlices(room);

        QCOMPARE(slices.size(), scan.recording.slices.size());
        for (std::size_t i = 0; i < slices.size(); ++i) {
            QCOMPARE(slices[i].step, static_cast<int>(i));
            QCOMPARE(slices[i].tilt, scan.recording.slices[i].tilt);
            QVERIFY(slices[i].ranges == scan.recording.slices[i].ranges);
        }
    }
}

void SimulatedRoomTest::takesFortySlicesASecond()
{
    FakeClock clock;
    SimulatedRoom room{corridor(), quickScanner(1.0), clock};

    allSlices(room);

    QVERIFY(clock.now() == 4 * 25ms);
}

void SimulatedRoomTest::theNextScanIsTheSame()
{
    FakeClock clock;
    SimulatedRoom room{corridor(), quickScanner(0.0), clock};
    const std::vector<ScanSlice> first = allSlices(room);

    QVERIFY(room.begin({}));
    const std::vector<ScanSlice> second = allSlices(room);

    QCOMPARE(second.size(), first.size());
    QVERIFY(second.back().ranges == first.back().ranges);
}

void SimulatedRoomTest::itsHeadStandsStillAfterStopMotion()
{
    FakeClock clock;
    SimulatedRoom room{corridor(), quickScanner(1.0), clock};
    std::atomic<int> slices{0};
    QVERIFY(room.stopMotion());
    std::jthread reading{[&](const std::stop_token& stop) {
        for (auto slice = room.next(stop); slice && *slice; slice = room.next(stop))
            ++slices;
    }};
    QTRY_VERIFY(clock.waits() > 2);
    QCOMPARE(slices.load(), 0);

    QVERIFY(room.resume());

    QTRY_COMPARE(slices.load(), 5);
}

void SimulatedRoomTest::isAScanner()
{
    FakeClock clock;
    const SimulatedRoom room{corridor(), quickScanner(1.0), clock};

    QVERIFY(room.isLive());
    QCOMPARE(room.name(), std::string("Simulated corridor"));
    QCOMPARE(room.plannedSlices().value(), 5);
    QCOMPARE(room.description().beams, 37);
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::SimulatedRoomTest)
#include "simulated_room_test.moc"
