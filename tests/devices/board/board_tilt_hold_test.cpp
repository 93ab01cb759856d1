// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <atomic>
#include <thread>

#include <QtTest>

#include "tests/devices/board/board_rig.h"
#include "tests/test_program.h"

namespace planewright {

/// An emergency stop comes from any thread at any time, also while requests are lost.
class BoardTiltHoldTest : public QObject {
    Q_OBJECT

private slots:
    void holdingTakesOneRoundTripWhileAnotherThreadWaitsForSamples();
    void noMotionSlipsInAfterAHold();
    void aHoldKeepsBackAMotionThatWouldBeRepeated();
    void aHoldWhoseRequestIsLostEndsTheHeartbeats();
    void aHoldWhoseReplyIsLostIsNeverASecondOne();
    void armingAfterAHoldOfUnknownFateLeavesTheTorque();
    void anyThreadMayAskForHealthAndMotor();
};

namespace {

using namespace std::chrono_literals;
using board::State;

constexpr int kPatience = 60'000;  // ms of a busy machine

/// Lets a clock that stands go on in small steps, each when somebody has waited for it. Declare it before the threads
/// that wait: it must outlive them.
class PassingTime {
public:
    explicit PassingTime(FakeClock& clock) : thread_([this, &clock](const std::stop_token& stop) { run(clock, stop); })
    {
    }

    /// No time passes while one of these lives. Declare it after the threads that wait: it must end before them.
    class Pause {
    public:
        explicit Pause(PassingTime& time) : time_(time) { time_.setPaused(true); }
        ~Pause() { time_.setPaused(false); }
        Pause(const Pause&) = delete;
        Pause& operator=(const Pause&) = delete;

    private:
        PassingTime& time_;
    };

private:
    void setPaused(bool is)
    {
        const std::scoped_lock lock(mutex_);
        isPaused_ = is;
    }
    void run(FakeClock& clock, const std::stop_token& stop)
    {
        for (int waits = 0; !stop.stop_requested(); std::this_thread::yield()) {
            const std::scoped_lock lock(mutex_);
            if (isPaused_ || clock.waits() == waits)
                continue;
            waits = clock.waits();
            clock.advance(500us);
        }
    }

    std::mutex mutex_;
    bool isPaused_ = false;
    std::jthread thread_;
};

/// Loses what it is told to.
class LossyTransport : public Transport {
public:
    struct Losses {
        std::atomic<bool> toBoard{false};
        std::atomic<bool> fromBoard{false};
        std::atomic<int> heartbeats{0};  ///< that were written
        std::atomic<int> estops{0};
        std::atomic<int> motions{0};
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
            if (frame.type == board::Move::kType) {
                ++losses_->motions;
                losses_->motionsAfterEstop += losses_->estops > 0 ? 1 : 0;
            }
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
    double pitch()
    {
        const std::scoped_lock lock(*mutex);
        return board->pitchAt(clock.now());
    }
    int torque()
    {
        const std::scoped_lock lock(*mutex);
        return board->torque();
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
    PassingTime time{rig.clock};
    QVERIFY(rig.tilt.connect({}) && rig.tilt.arm({}) && rig.tilt.moveTo(degrees(160.0), degrees(100.0)));
    std::jthread sampler{[&](const std::stop_token& stop) {
        while (!stop.stop_requested() && rig.tilt.sample(rig.clock.now() + 10s, stop)) {
        }
    }};
    QTRY_VERIFY_WITH_TIMEOUT(rig.pitch() > degrees(91.0), kPatience);
    std::atomic<bool> isHeld{false};
    std::jthread holder;
    const PassingTime::Pause pause{time};

    holder = std::jthread{[&] { isHeld = rig.tilt.hold().has_value(); }};
    QTRY_COMPARE_WITH_TIMEOUT(rig.losses->estops.load(), 1, kPatience);  // no time has passed
    rig.clock.advance(500us);                                            // 0.2 ms there, 0.06 ms inside, 0.2 ms back

    QTRY_VERIFY_WITH_TIMEOUT(isHeld, kPatience);
    QCOMPARE(rig.state(), State::Estopped);
}

void BoardTiltHoldTest::noMotionSlipsInAfterAHold()
{
    for (int run = 0; run < 5; ++run) {
        LossyRig rig{BoardRig::level(), FakeClock::Kind::Stands};
        PassingTime time{rig.clock};
        QVERIFY(rig.tilt.connect({}) && rig.tilt.arm({}));
        std::atomic<int> moves{0};
        std::atomic<bool> wasHeld{false};
        std::jthread mover{[&](const std::stop_token& stop) {
            while (!wasHeld && !stop.stop_requested()) {
                const auto moved = rig.tilt.moveTo(degrees(moves % 2 == 0 ? 100.0 : 80.0), degrees(100.0));
                wasHeld = !moved && moved.error().code == ErrorCode::Interrupted;
                ++moves;
            }
        }};
        QTRY_VERIFY_WITH_TIMEOUT(moves > 2, kPatience);

        QVERIFY(rig.tilt.hold());

        QTRY_VERIFY_WITH_TIMEOUT(wasHeld, kPatience);
        QCOMPARE(rig.state(), State::Estopped);
        QCOMPARE(rig.losses->motionsAfterEstop.load(), 0);
        QCOMPARE(rig.torque(), 300);
    }
}

void BoardTiltHoldTest::aHoldKeepsBackAMotionThatWouldBeRepeated()
{
    LossyRig rig{BoardRig::level(), FakeClock::Kind::Stands};
    PassingTime time{rig.clock};
    QVERIFY(rig.tilt.connect({}) && rig.tilt.arm({}));
    std::atomic<bool> isInterrupted{false};
    std::atomic<bool> isOver{false};
    std::jthread mover;
    std::jthread holder;
    {
        const PassingTime::Pause pause{time};
        rig.losses->fromBoard = true;
        mover = std::jthread{[&] {
            const auto moved = rig.tilt.moveTo(degrees(100.0), degrees(100.0));
            isInterrupted = !moved && moved.error().code == ErrorCode::Interrupted;
        }};
        QTRY_COMPARE_WITH_TIMEOUT(rig.losses->motions.load(), 1, kPatience);
        holder = std::jthread{[&] { isOver = !rig.tilt.hold(); }};
        QTRY_COMPARE_WITH_TIMEOUT(rig.losses->estops.load(), 1, kPatience);
    }

    QTRY_VERIFY_WITH_TIMEOUT(isOver && isInterrupted, kPatience);

    QCOMPARE(rig.losses->motions.load(), 1);
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
    PassingTime time{rig.clock};
    std::atomic<int> asked{0};
    std::jthread panel{[&](const std::stop_token& stop) {
        while (!stop.stop_requested()) {
            asked += rig.tilt.health().good > 0 && rig.tilt.motor().voltage > 0.0 ? 1 : 0;
            std::this_thread::yield();
        }
    }};

    QVERIFY(rig.tilt.connect({}) && rig.tilt.arm({}) && rig.tilt.moveTo(degrees(100.0), degrees(100.0)));
    QVERIFY(rig.watch(50ms));

    QTRY_VERIFY_WITH_TIMEOUT(asked > 0, kPatience);
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::BoardTiltHoldTest)
#include "board_tilt_hold_test.moc"
