// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <atomic>
#include <thread>

#include <QtTest>

#include "tests/devices/board/board_rig.h"

namespace planewright {

/// An emergency stop comes from any thread at any time, also while requests are lost.
class BoardTiltHoldTest : public QObject {
    Q_OBJECT

private slots:
    void holdingTakesOneRoundTripWhileAnotherThreadWaitsForSamples();
    void noMotionSlipsInAfterAHold();
    void aHoldWhoseRequestIsLostEndsTheHeartbeats();
    void aHoldWhoseReplyIsLostIsNeverASecondOne();
    void armingAfterAHoldOfUnknownFateLeavesTheTorque();
    void anyThreadMayAskForHealthAndMotor();
};

namespace {

using namespace std::chrono_literals;
using board::State;

/// Lets a clock that stands go on in small steps, each when somebody has waited for it, until something is done.
template <class Done>
void goOnUntil(FakeClock& clock, Done&& done)
{
    while (!done()) {
        const int waits = clock.waits();
        while (!done() && clock.waits() <= waits)
            std::this_thread::yield();
        clock.advance(200us);
    }
}

/// Does something in another thread while the clock goes on.
template <class Work>
void doWhileTimePasses(FakeClock& clock, Work&& work)
{
    std::atomic<bool> done{false};
    std::jthread worker{[&] {
        work();
        done = true;
    }};
    goOnUntil(clock, [&] { return done.load(); });
}

/// Loses what it is told to.
class LossyTransport : public Transport {
public:
    struct Losses {
        std::atomic<bool> toBoard{false};
        std::atomic<bool> fromBoard{false};
        std::atomic<int> heartbeats{0};  ///< that were written
        std::atomic<int> estops{0};
        std::atomic<int> motionsAfterEstop{0};
    };

    LossyTransport(std::unique_ptr<Transport> link, std::shared_ptr<Losses> losses)
        : link_(std::move(link)), losses_(std::move(losses))
    {
    }

    std::string name() const override { return link_->name(); }
    Result<Arrival> read(std::span<std::uint8_t> into, std::chrono::nanoseconds deadline,
                         const std::stop_token& stop) override
    {
        for (;;) {
            Result<Arrival> arrival = link_->read(into, deadline, stop);
            if (!losses_->fromBoard || !arrival || arrival->count == 0)
                return arrival;
        }
    }
    Result<void> write(std::span<const std::uint8_t> bytes, std::chrono::nanoseconds deadline) override
    {
        const Result<void> written = losses_->toBoard ? Result<void>{} : link_->write(bytes, deadline);
        for (const board::Frame& frame : board::FrameParser{}.push(bytes)) {
            losses_->heartbeats += frame.type == board::Heartbeat::kType ? 1 : 0;
            losses_->estops += frame.type == board::Estop::kType ? 1 : 0;
            losses_->motionsAfterEstop += frame.type == board::Move::kType && losses_->estops > 0 ? 1 : 0;
        }
        return written;
    }
    void close() override { link_->close(); }

private:
    std::unique_ptr<Transport> link_;
    std::shared_ptr<Losses> losses_;
};

/// As BoardRig, with a link that can lose things.
struct LossyRig {
    explicit LossyRig(const BoardTiltOptions& options = BoardRig::level(),
                      FakeClock::Kind kind = FakeClock::Kind::Jumps)
        : clock(kind),
          tilt(std::make_unique<LossyTransport>(std::make_unique<EmulatedLink>(board, mutex, clock, "emulated board"),
                                                losses),
               clock, options)
    {
    }

    State state()
    {
        const std::scoped_lock lock(*mutex);
        board->pitchAt(clock.now());
        return board->state();
    }

    FakeClock clock;
    std::shared_ptr<std::mutex> mutex = std::make_shared<std::mutex>();
    std::shared_ptr<EmulatedBoard> board = EmulatedBoard::make(levelBoard()).value();
    std::shared_ptr<LossyTransport::Losses> losses = std::make_shared<LossyTransport::Losses>();
    BoardTilt tilt;

    bool isUnderWay()
    {
        return tilt.connect({}) && tilt.arm({}) && tilt.moveTo(degrees(160.0), degrees(20.0)) &&
               tilt.sample(clock.now() + 300ms, {});
    }
};

}  // namespace

void BoardTiltHoldTest::holdingTakesOneRoundTripWhileAnotherThreadWaitsForSamples()
{
    BoardTiltOptions options = BoardRig::level();
    options.positionRate = 1;  // who waits for a sample waits long
    LossyRig rig{options, FakeClock::Kind::Stands};
    bool isMoving = false;
    doWhileTimePasses(rig.clock, [&] {
        isMoving = rig.tilt.connect({}) && rig.tilt.arm({}) && rig.tilt.moveTo(degrees(160.0), degrees(100.0));
    });
    QVERIFY(isMoving);
    std::jthread sampler{[&](const std::stop_token& stop) {
        while (!stop.stop_requested() && rig.tilt.sample(rig.clock.now() + 10s, stop)) {
        }
    }};
    goOnUntil(rig.clock, [&, until = rig.clock.now() + 20ms] { return rig.clock.now() >= until; });
    QCOMPARE(rig.state(), State::Moving);

    std::atomic<bool> isHeld{false};
    std::jthread holder{[&] { isHeld = rig.tilt.hold().has_value(); }};
    QTRY_COMPARE(rig.losses->estops.load(), 1);  // no time has passed
    rig.clock.advance(500us);                    // 0.2 ms there, 0.06 ms inside, 0.2 ms back

    QTRY_VERIFY(isHeld);
    QCOMPARE(rig.state(), State::Estopped);
}

void BoardTiltHoldTest::noMotionSlipsInAfterAHold()
{
    for (int run = 0; run < 4; ++run) {
        LossyRig rig{BoardRig::level(), FakeClock::Kind::Stands};
        bool isArmed = false;
        doWhileTimePasses(rig.clock, [&] { isArmed = rig.tilt.connect({}) && rig.tilt.arm({}); });
        QVERIFY(isArmed);
        std::atomic<bool> wasHeld{false};
        std::atomic<bool> isMover{false};
        std::jthread mover{[&] {
            for (int i = 0; !wasHeld; ++i) {
                const auto moved = rig.tilt.moveTo(degrees(i % 2 == 0 ? 100.0 : 80.0), degrees(100.0));
                isMover = true;
                wasHeld = !moved && moved.error().code == ErrorCode::Interrupted;
            }
        }};
        goOnUntil(rig.clock, [&] { return isMover.load(); });

        std::atomic<bool> isHeld{false};
        std::jthread holder{[&] { isHeld = rig.tilt.hold().has_value(); }};
        goOnUntil(rig.clock, [&] { return isHeld.load() && wasHeld.load(); });

        QCOMPARE(rig.state(), State::Estopped);
        QCOMPARE(rig.losses->motionsAfterEstop.load(), 0);
        const double rest = rig.board->pitchAt(rig.clock.now() + 100ms);
        QCOMPARE(rig.board->pitchAt(rig.clock.now() + 2s), rest);
        QCOMPARE(rig.board->torque(), 300);
    }
}

void BoardTiltHoldTest::aHoldWhoseRequestIsLostEndsTheHeartbeats()
{
    LossyRig rig;
    QVERIFY(rig.isUnderWay());
    rig.losses->toBoard = true;

    const auto held = rig.tilt.hold();
    QCOMPARE(held.error().code, ErrorCode::DeviceLost);
    rig.losses->toBoard = false;
    const int beats = rig.losses->heartbeats;
    for (int i = 0; i < 100; ++i)
        QVERIFY(rig.tilt.sample(rig.clock.now() + 10ms, {}));

    QCOMPARE(rig.losses->heartbeats.load(), beats);
    QCOMPARE(rig.board->state(), State::Stopped);
    QCOMPARE(rig.tilt.moveTo(degrees(100.0), degrees(20.0)).error().code, ErrorCode::Interrupted);
    QVERIFY(rig.tilt.hold());
    QCOMPARE(rig.board->state(), State::Estopped);
    QCOMPARE(rig.board->torque(), 300);
    QVERIFY(rig.tilt.arm({}));
    QVERIFY(rig.tilt.sample(rig.clock.now() + 1s, {}));
    QVERIFY(rig.losses->heartbeats > beats);
}

void BoardTiltHoldTest::aHoldWhoseReplyIsLostIsNeverASecondOne()
{
    LossyRig rig;
    QVERIFY(rig.isUnderWay());
    rig.losses->fromBoard = true;

    QCOMPARE(rig.tilt.hold().error().code, ErrorCode::DeviceLost);
    QCOMPARE(rig.board->state(), State::Estopped);
    QCOMPARE(rig.tilt.hold().error().code, ErrorCode::DeviceLost);
    rig.losses->fromBoard = false;
    QVERIFY(rig.tilt.hold());
    QVERIFY(rig.tilt.hold());

    QCOMPARE(rig.board->torque(), 300);
}

void BoardTiltHoldTest::armingAfterAHoldOfUnknownFateLeavesTheTorque()
{
    LossyRig rig;
    QVERIFY(rig.isUnderWay());
    rig.losses->fromBoard = true;
    QVERIFY(!rig.tilt.hold());
    QVERIFY(!rig.tilt.arm({}));
    QCOMPARE(rig.board->state(), State::Estopped);
    QCOMPARE(rig.board->torque(), 300);
    rig.losses->fromBoard = false;

    QVERIFY(rig.tilt.arm({}));

    QCOMPARE(rig.board->state(), State::Armed);
    QCOMPARE(rig.board->torque(), 1000);
}

void BoardTiltHoldTest::anyThreadMayAskForHealthAndMotor()
{
    BoardRig rig{levelBoard(), BoardRig::level(), FakeClock::Kind::Stands};
    std::atomic<int> asked{0};
    std::jthread panel{[&](const std::stop_token& stop) {
        while (!stop.stop_requested()) {
            asked += rig.tilt.health().good > 0 && rig.tilt.motor().voltage > 0.0 ? 1 : 0;
            std::this_thread::yield();
        }
    }};

    bool fine = false;
    doWhileTimePasses(rig.clock, [&] {
        fine = rig.tilt.connect({}) && rig.tilt.arm({}) && rig.tilt.moveTo(degrees(100.0), degrees(100.0)) &&
               rig.watch(50ms).has_value();
    });

    QVERIFY(fine);
    QTRY_VERIFY(asked > 0);
}

}  // namespace planewright

QTEST_GUILESS_MAIN(planewright::BoardTiltHoldTest)
#include "board_tilt_hold_test.moc"
