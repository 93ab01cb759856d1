// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>
#include <random>

#include <QtTest>

#include "devices/board/clock_sync.h"
#include "tests/test_program.h"

namespace planewright {

class BoardClockSyncTest : public QObject {
    Q_OBJECT

private slots:
    void aHeartbeatThatTakesEquallyLongBothWaysGivesTheTime();
    void theQuickestRoundTripCounts();
    void aClockThatRunsFastIsFollowed_data();
    void aClockThatRunsFastIsFollowed();
    void slowHeartbeatsDoNotBendTheLine();
    void aLineIsBelievedForAMinuteWhenAllBecomeSlow();
    void stampsThatCannotBeAreRefused();
    void momentsFarFromAllHeartbeatsHaveNoTime();
    void anotherStartForgetsEverything();
    void hostileStampsOverflowNothing();
};

namespace {

using namespace board;
using namespace std::chrono_literals;
using std::chrono::microseconds;
using std::chrono::nanoseconds;

/// A board whose clock began at a moment of the host and runs too fast by `drift`.
struct Board {
    nanoseconds start{0};
    double drift = 0.0;

    microseconds at(nanoseconds host) const
    {
        return microseconds{std::llround(static_cast<double>((host - start).count()) * (1.0 + drift) / 1000.0)};
    }
    /// A heartbeat sent at a moment, that long under way to the board, there, and back.
    HeartbeatStamps heartbeat(nanoseconds sent, nanoseconds there, nanoseconds inside, nanoseconds back) const
    {
        return {sent, at(sent + there), at(sent + there + inside), sent + there + inside + back};
    }
};

}  // namespace

void BoardClockSyncTest::aHeartbeatThatTakesEquallyLongBothWaysGivesTheTime()
{
    const Board clock{-3s};
    ClockSync sync;
    QVERIFY(!sync.isSynchronised());
    QVERIFY(!sync.toHost(0));

    QVERIFY(sync.add(clock.heartbeat(10s, 1ms, 100us, 1ms)));

    QVERIFY(sync.isSynchronised());
    QVERIFY(sync.roundTrip() == 2ms);
    QVERIFY(*sync.toHost(13'000'000) == 10s);
    QVERIFY(*sync.toHost(14'500'000) == 11500ms);
}

void BoardClockSyncTest::theQuickestRoundTripCounts()
{
    const Board clock{0s};
    ClockSync sync;

    sync.add(clock.heartbeat(10s, 1ms, 0ms, 1ms));
    sync.add(clock.heartbeat(10050ms, 40ms, 0ms, 1ms));
    sync.add(clock.heartbeat(10700ms, 1ms, 0ms, 30ms));

    QVERIFY(sync.roundTrip() == 2ms);
    QVERIFY(*sync.toHost(10'800'000) == 10800ms);
}

void BoardClockSyncTest::aClockThatRunsFastIsFollowed_data()
{
    QTest::addColumn<double>("drift");
    QTest::newRow("a crystal") << 50e-6;
    QTest::newRow("a slow crystal") << -100e-6;
    QTest::newRow("a resonator") << 0.004;
}

void BoardClockSyncTest::aClockThatRunsFastIsFollowed()
{
    QFETCH(double, drift);
    const Board clock{2s, drift};
    ClockSync sync;
    std::mt19937 random{11};
    for (nanoseconds sent = 5s; sent < 25s; sent += 50ms) {
        const nanoseconds jitter{random() % 300'000};
        QVERIFY(sync.add(clock.heartbeat(sent, 500us + jitter, 50us, 500us)));
    }

    QVERIFY(std::abs(sync.drift() - drift) < 20e-6);
    for (const nanoseconds at : {nanoseconds{24s}, nanoseconds{25s}, nanoseconds{25500ms}}) {
        const auto host = sync.toHost(static_cast<std::uint64_t>(clock.at(at).count()));
        QVERIFY(std::chrono::abs(*host - at) < 150us);  // half of the jitter
    }
}

void BoardClockSyncTest::slowHeartbeatsDoNotBendTheLine()
{
    const Board clock{0s, 100e-6};
    ClockSync sync;
    for (nanoseconds sent = 1s; sent < 11s; sent += 50ms) {
        const bool isSlow = sent > 6s && sent < 9s;
        sync.add(clock.heartbeat(sent, 500us, 50us, isSlow ? 80ms : 500us));
    }

    const auto host = sync.toHost(static_cast<std::uint64_t>(clock.at(11s).count()));

    QVERIFY(std::chrono::abs(*host - 11s) < 50us);
    QVERIFY(std::abs(sync.drift() - 100e-6) < 5e-6);
}

void BoardClockSyncTest::aLineIsBelievedForAMinuteWhenAllBecomeSlow()
{
    const Board clock{0s, 100e-6};
    ClockSync sync;
    nanoseconds sent = 1s;
    for (; sent < 11s; sent += 50ms)
        sync.add(clock.heartbeat(sent, 500us, 50us, 500us));
    for (; sent < 69s; sent += 50ms)
        sync.add(clock.heartbeat(sent, 500us, 50us, 80ms));

    const auto host = sync.toHost(static_cast<std::uint64_t>(clock.at(69s).count()));
    QVERIFY(std::chrono::abs(*host - 69s) < 200us);
    QVERIFY(sync.roundTrip() == 1ms);
    for (; sent < 75s; sent += 50ms)
        sync.add(clock.heartbeat(sent, 500us, 50us, 80ms));

    QVERIFY(sync.roundTrip() > 80ms);
}

void BoardClockSyncTest::stampsThatCannotBeAreRefused()
{
    ClockSync sync;

    QVERIFY(!sync.add({10ms, 5ms, 5ms, 9ms}));    // answered before it was asked
    QVERIFY(!sync.add({10ms, 5ms, 4ms, 12ms}));   // sent before it was received
    QVERIFY(!sync.add({10ms, 5ms, 15ms, 12ms}));  // took longer than the whole
    QVERIFY(!sync.add({10ms, -5us, 5us, 12ms}));

    QVERIFY(!sync.isSynchronised());
}

void BoardClockSyncTest::momentsFarFromAllHeartbeatsHaveNoTime()
{
    const Board clock{0s};
    ClockSync sync;
    sync.add(clock.heartbeat(3600s, 1ms, 0ms, 1ms));

    QVERIFY(sync.toHost(3'600'000'000));
    QVERIFY(sync.toHost(3'600'000'000 - 500'000'000));
    QVERIFY(!sync.toHost(3'600'000'000 + 700'000'000));
    QVERIFY(!sync.toHost(0));
    QVERIFY(!sync.toHost(~std::uint64_t{0}));
}

void BoardClockSyncTest::anotherStartForgetsEverything()
{
    ClockSync sync;
    for (nanoseconds sent = 1s; sent < 8s; sent += 50ms)
        sync.add(Board{0s, 0.004}.heartbeat(sent, 1ms, 0ms, 1ms));

    sync.restart();
    QVERIFY(!sync.isSynchronised());
    sync.add(Board{9s}.heartbeat(10s, 1ms, 0ms, 1ms));

    QVERIFY(*sync.toHost(1'000'000) == 10s);
    QCOMPARE(sync.drift(), 0.0);
}

void BoardClockSyncTest::hostileStampsOverflowNothing()
{
    std::mt19937_64 random{2};
    ClockSync sync;
    int taken = 0;
    for (int i = 0; i < 20'000; ++i) {
        const int shift = static_cast<int>(random() % 60);
        const microseconds received{static_cast<std::int64_t>(random() >> (1 + shift))};
        const nanoseconds sent{50'000'000LL * i};
        const microseconds boardSent = i % 2 == 0 ? received : microseconds{static_cast<std::int64_t>(random() >> 1)};
        taken += sync.add({sent, received, boardSent, sent + 1ms}) ? 1 : 0;
        sync.toHost(random() >> shift);
    }

    QVERIFY(taken > 1000);
    QVERIFY(std::abs(sync.drift()) <= 0.0102);
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::BoardClockSyncTest)
#include "board_clock_sync_test.moc"
