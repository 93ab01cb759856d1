// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <future>
#include <thread>

#include <QtTest>

#include "devices/dynamixel/bus_turns.h"
#include "devices/dynamixel/requests.h"
#include "tests/devices/dynamixel/servo_rig.h"
#include "tests/test_program.h"

namespace planewright {

using namespace std::chrono_literals;

class DynamixelHoldTest : public QObject {
    Q_OBJECT

private slots:
    void whileSamplesComeItStopsWithinOneRoundTrip_data();
    void whileSamplesComeItStopsWithinOneRoundTrip();
    void withoutSamplesItAsksWhereItIsFirst();
    void aStandingServoStaysWhereItStands();
    void aHeldServoRefusesToMoveUntilItIsArmed();
    void aServoWithoutTorqueIsLeftAlone();
    void aServoThatIsNotHeardIsToldAllTheSame();
    void aHoldComesNextWhileASampleWaits();
    void aHoldEndsArming();
    void noMotionSlipsInAfterAHold();
    void whoeverIsUrgentIsNotKeptWaiting();
};

namespace {

/// Moves a clock that stands on, until something is done.
template <class Future>
void runClockUntil(FakeClock& clock, Future& future)
{
    for (int i = 0; i < 20'000 && future.wait_for(0s) != std::future_status::ready; ++i) {
        clock.advance(200us);
        std::this_thread::sleep_for(100us);
    }
}

}  // namespace

void DynamixelHoldTest::whileSamplesComeItStopsWithinOneRoundTrip_data()
{
    QTest::addColumn<int>("model");
    QTest::addColumn<int>("goalAddress");
    QTest::addColumn<double>("milliseconds");

    // 57142 baud: 9 bytes there, 0.5 ms, 6 back; in 2.0 16 and 11.
    QTest::newRow("RX-64") << 64 << 30 << 15 * 0.175 + 0.5;
    QTest::newRow("XM430") << 1020 << 116 << 27 * 0.175 + 0.5;
}

void DynamixelHoldTest::whileSamplesComeItStopsWithinOneRoundTrip()
{
    QFETCH(int, model);
    QFETCH(int, goalAddress);
    QFETCH(double, milliseconds);
    ServoRig rig{emulated(static_cast<std::uint16_t>(model))};
    QVERIFY(rig.ready());
    QVERIFY(rig.tilt->moveTo(degrees(70.0), degrees(100.0)));
    while (rig.truth(rig.clock.now()) < degrees(20.0))
        rig.sample().value();
    rig.link->forget();
    const auto began = rig.clock.now();
    const double there = rig.truth(began);

    QVERIFY(rig.tilt->hold());

    QVERIFY(std::abs(std::chrono::duration<double, std::milli>(rig.clock.now() - began).count() - milliseconds) < 0.1);
    QCOMPARE(rig.link->written().size(), std::size_t(1));
    QCOMPARE(int(rig.link->written()[0].packet.parameters[0]), goalAddress);
    // Bytes on the line and the brakes: 1.45° at 100°/s and 60 rad/s², and it comes back to where it was.
    for (int i = 0; i < 400; ++i) {
        const double angle = rig.truth(began + i * 5ms);
        QVERIFY(angle > there - degrees(0.5) && angle < there + degrees(2.2));
    }
    QVERIFY(std::abs(rig.truth(began + 2s) - there) < degrees(1.0));
}

void DynamixelHoldTest::withoutSamplesItAsksWhereItIsFirst()
{
    ServoRig rig;
    QVERIFY(rig.ready());
    QVERIFY(rig.tilt->moveTo(degrees(70.0), degrees(60.0)));
    rig.clock.advance(300ms);
    rig.link->forget();
    const double there = rig.truth(rig.clock.now());

    QVERIFY(rig.tilt->hold());

    QCOMPARE(rig.link->written().size(), std::size_t(2));
    QCOMPARE(int(rig.link->written()[0].packet.code), 0x02);
    QCOMPARE(int(rig.link->written()[1].packet.code), int(kWrite));
    QVERIFY(there > degrees(10.0));
    QVERIFY(std::abs(rig.truth(rig.clock.now() + 2s) - there) < degrees(1.0));
}

void DynamixelHoldTest::aStandingServoStaysWhereItStands()
{
    ServoRig rig;
    QVERIFY(rig.ready());
    QVERIFY(rig.tilt->moveTo(degrees(-30.0), 1.0));
    const double there = rig.arrive().value().pitch;

    QVERIFY(rig.tilt->hold());
    QVERIFY(rig.tilt->hold());

    QVERIFY(std::abs(rig.truth(rig.clock.now() + 2s) - there) < 1e-6);
}

void DynamixelHoldTest::aHeldServoRefusesToMoveUntilItIsArmed()
{
    ServoRig rig;
    QVERIFY(rig.ready());
    QVERIFY(rig.tilt->hold());
    rig.link->forget();

    const auto moved = rig.tilt->moveTo(degrees(10.0), 1.0);

    QVERIFY(!moved);
    QCOMPARE(moved.error().code, ErrorCode::Interrupted);
    QVERIFY(says(moved.error().message, {"held", "arm"}));
    QVERIFY(rig.link->written().empty());
    QVERIFY(rig.sample().value());
    QVERIFY(rig.tilt->arm({}));
    QVERIFY(rig.tilt->moveTo(degrees(10.0), 1.0));
    QVERIFY(rig.arrive());
}

void DynamixelHoldTest::aServoWithoutTorqueIsLeftAlone()
{
    ServoRig rig;
    QVERIFY(rig.tilt->hold());
    QVERIFY(rig.tilt->connect({}));
    rig.link->forget();

    QVERIFY(rig.tilt->hold());

    // A goal would bring the torque with it.
    QVERIFY(rig.link->written().empty());
    QCOMPARE(rig.tilt->moveTo(0.0, 1.0).error().code, ErrorCode::Interrupted);
}

void DynamixelHoldTest::aServoThatIsNotHeardIsToldAllTheSame()
{
    ServoRig rig{{}, {{"servo-silent", 5}}};
    QVERIFY(rig.ready());
    QVERIFY(rig.tilt->moveTo(degrees(70.0), degrees(60.0)));
    while (rig.truth(rig.clock.now()) < degrees(20.0))
        rig.sample().value();
    rig.turn = 5;
    rig.clock.advance(100ms);

    const auto held = rig.tilt->hold();

    QVERIFY(!held);
    QCOMPARE(held.error().code, ErrorCode::DeviceLost);
    // It heard the goal although nothing was heard of it: the last position that was known.
    QVERIFY(std::abs(rig.truth(rig.clock.now() + 3s) - degrees(20.0)) < degrees(2.0));
}

void DynamixelHoldTest::aHoldComesNextWhileASampleWaits()
{
    ServoRig rig{{}, {}, {}, FakeClock::Kind::Stands};
    auto ready = std::async(std::launch::async, [&] { return rig.ready(); });
    runClockUntil(rig.clock, ready);
    QVERIFY(ready.get());
    rig.link->forget();

    // The bus is busy with a sample; behind it wait a hold, and a motion of the thread that samples.
    auto scanning = std::async(std::launch::async, [&] {
        const auto sample = rig.tilt->sample(rig.clock.now() + 1s, {});
        const auto moved = rig.tilt->moveTo(degrees(40.0), 1.0);
        return std::pair{sample.has_value() && sample->has_value(), moved};
    });
    QTRY_COMPARE(rig.link->written().size(), std::size_t(1));
    auto holding = std::async(std::launch::async, [&] { return rig.tilt->hold(); });
    // It has set its mark before it waits for the bus; no time has passed.
    QTRY_VERIFY(rig.tilt->isHeld());
    runClockUntil(rig.clock, scanning);
    runClockUntil(rig.clock, holding);

    QVERIFY(holding.get());
    const auto [sampled, moved] = scanning.get();
    QVERIFY(sampled);
    QVERIFY(!moved);
    QCOMPARE(moved.error().code, ErrorCode::Interrupted);
    // The sample, then the hold; on a busy machine the answer to either may come too late, and it is said again.
    const auto written = rig.link->written();
    const auto hold =
        std::ranges::find_if(written, [](const auto& each) { return int(each.packet.code) == int(kWrite); });
    QVERIFY(hold != written.begin() && hold != written.end());
    QVERIFY(std::all_of(written.begin(), hold, [](const auto& each) { return int(each.packet.code) == 0x02; }));
    for (const auto& each : std::span{hold, written.end()}) {
        QCOMPARE(int(each.packet.code), int(kWrite));
        QCOMPARE(fromLittleEndian(std::span{each.packet.parameters}.subspan(1)), std::uint32_t(512));
    }
}

void DynamixelHoldTest::aHoldEndsArming()
{
    ServoRig rig{{}, {}, {}, FakeClock::Kind::Stands};
    auto connecting = std::async(std::launch::async, [&] { return rig.tilt->connect({}); });
    runClockUntil(rig.clock, connecting);
    QVERIFY(connecting.get());
    rig.link->forget();
    auto arming = std::async(std::launch::async, [&] { return rig.tilt->arm({}); });
    QTRY_COMPARE(rig.link->written().size(), std::size_t(1));

    QVERIFY(rig.tilt->hold());
    runClockUntil(rig.clock, arming);

    const auto armed = arming.get();
    QVERIFY(!armed);
    QCOMPARE(armed.error().code, ErrorCode::Interrupted);
    QCOMPARE(rig.tilt->moveTo(0.1, 0.1).error().code, ErrorCode::Interrupted);
}

void DynamixelHoldTest::noMotionSlipsInAfterAHold()
{
    // One thread scans as it likes; another one looks and holds. The last word is the hold's.
    ServoRig rig;
    QVERIFY(rig.ready());
    std::atomic<bool> isHeldForGood{false};
    std::atomic<int> rounds{0};
    std::jthread scanning{[&](const std::stop_token& stop) {
        for (int i = 0; !stop.stop_requested(); ++i) {
            if (!rig.tilt->moveTo(degrees(i % 2 == 0 ? 5.0 : -5.0), 1.0) && !isHeldForGood)
                (void)rig.tilt->arm(stop);
            (void)rig.tilt->sample(rig.clock.now() + 20ms, stop);
            ++rounds;
        }
    }};
    const auto waitForRounds = [&](int more) {
        const int until = rounds + more;
        QTRY_VERIFY(rounds >= until);
    };
    for (int i = 0; i < 40; ++i) {
        (void)rig.tilt->health();
        (void)rig.tilt->motor();
        QVERIFY(rig.tilt->hold());
        waitForRounds(i % 3);
    }

    isHeldForGood = true;
    waitForRounds(2);  // an arm() that had begun is over
    QVERIFY(rig.tilt->hold());
    const std::size_t written = rig.link->written().size();
    waitForRounds(5);
    scanning.request_stop();
    scanning.join();

    const auto all = rig.link->written();
    for (std::size_t i = written; i < all.size(); ++i)
        QCOMPARE(int(all[i].packet.code), 0x02);
    QCOMPARE(rig.tilt->moveTo(0.0, 1.0).error().code, ErrorCode::Interrupted);
}

void DynamixelHoldTest::whoeverIsUrgentIsNotKeptWaiting()
{
    // Two threads that come back to the bus without a pause; a plain mutex may never let a third one in.
    BusTurns turns;
    int value = 0;
    const auto ask = [&](const std::stop_token& stop) {
        while (!stop.stop_requested()) {
            const BusTurns::Turn turn(turns, false);
            ++value;
        }
    };
    std::jthread one{ask};
    std::jthread two{ask};

    for (int i = 0; i < 200; ++i) {
        const BusTurns::Turn turn(turns, true);
        const int before = value;
        std::this_thread::yield();
        QCOMPARE(value, before);
    }
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::DynamixelHoldTest)
#include "dynamixel_hold_test.moc"
