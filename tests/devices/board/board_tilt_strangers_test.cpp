// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <random>

#include <QtTest>

#include "tests/devices/board/board_rig.h"
#include "tests/test_program.h"

namespace planewright {

/// Boards that are not what they should be: old, of another kind, broken, or malicious.
class BoardTiltStrangersTest : public QObject {
    Q_OBJECT

private slots:
    void aBoardOfAnotherVersionIsRefused();
    void aServoThatCannotBeIsRefused();
    void aBoardWithNarrowerLimitsIsRefused();
    void aReplyOfAnotherKindIsNone();
    void whatTalksWithoutEndIsNoBoard();
    void aBoardThatRefusesToBeArmedIsReported();
    void aMoveThatTheBoardRefusesIsReported();
    void eventsThatAreNotKnownAreCountedAndPassedOver();
    void eventsOfTheWrongLengthAreCorrupt();
    void anglesWithoutAPossibleTimeAreNone();
    void anglesThatComeOutOfOrderAreDropped();
    void heartbeatsThatReachTheBoardTogetherAreNoNewStart();
    void randomMessagesDoNoHarm();
};

namespace {

using namespace std::chrono_literals;
using namespace board;
using std::chrono::nanoseconds;

/// Answers as a test says, and says what a test wants.
class ScriptedBoard : public EmulatedDevice {
public:
    /// What an honest board of today answers.
    static Message honestAnswer(const Frame& frame, nanoseconds now)
    {
        const std::uint64_t us = static_cast<std::uint64_t>(now.count()) / 1000;
        const Message request = *toMessage(frame);
        if (std::holds_alternative<Hello>(request))
            return HelloReply{1, 0x0100, {}, 63, 64, 2'000'000, 1023, 512, 300'000, 0};
        if (const auto* beat = std::get_if<Heartbeat>(&request))
            return HeartbeatReply{beat->hostUs, us, us, State::Armed, board::Fault::None};
        if (const auto* config = std::get_if<SetConfig>(&request))
            return SetConfigReply{*config};
        if (std::holds_alternative<GetStatus>(request))
            return StatusReply{};
        if (std::holds_alternative<Arm>(request))
            return ArmReply{{State::Armed, 512}};
        if (std::holds_alternative<Move>(request))
            return MoveReply{{512, 100}};
        return Nak{NakCode::UnknownType, frame.type, 0};
    }

    std::function<std::optional<Message>(const Frame&, nanoseconds)> answer = [](const Frame& frame, nanoseconds now) {
        return std::optional{honestAnswer(frame, now)};
    };
    bool talksWithoutEnd = false;

    void say(const Frame& frame, nanoseconds at) { sent_.push_back({at, encodeFrame(frame)}); }

    void receive(std::span<const std::uint8_t> bytes, nanoseconds now) override
    {
        for (const Frame& frame : parser_.push(bytes)) {
            if (const auto reply = answer(frame, now))
                say(toFrame(frame.seq, *reply), now + 100us);
        }
    }
    std::vector<EmulatedOutput> takeOutput(nanoseconds now) override
    {
        std::vector<EmulatedOutput> out;
        std::erase_if(sent_, [&](const EmulatedOutput& output) {
            if (output.at <= now)
                out.push_back(output);
            return output.at <= now;
        });
        if (talksWithoutEnd && now >= talked_ + 1ms) {
            out.push_back({now, std::vector<std::uint8_t>(1000, 'x')});
            talked_ = now;
        }
        return out;
    }
    std::optional<nanoseconds> nextOutput() const override
    {
        std::optional<nanoseconds> first;
        for (const EmulatedOutput& output : sent_)
            first = std::min(first.value_or(output.at), output.at);
        return talksWithoutEnd ? std::optional{talked_ + 1ms} : first;
    }
    bool isConnected(nanoseconds) override { return true; }

private:
    FrameParser parser_;
    std::vector<EmulatedOutput> sent_;
    nanoseconds talked_{0};
};

struct Strange {
    FakeClock clock;
    std::shared_ptr<ScriptedBoard> board = std::make_shared<ScriptedBoard>();
    BoardTilt tilt{std::make_unique<EmulatedLink>(board, std::make_shared<std::mutex>(), clock, "stranger"), clock,
                   BoardRig::level()};

    /// Answers one kind of request in another way.
    template <class Request>
    void answering(std::optional<Message> reply)
    {
        board->answer = [reply](const Frame& frame, nanoseconds now) {
            return frame.type == Request::kType ? reply : std::optional{ScriptedBoard::honestAnswer(frame, now)};
        };
    }
    void sayPosition(int number, nanoseconds happened, int pos)
    {
        const auto us = static_cast<std::uint64_t>(happened / 1us);
        board->say(
            toFrame(static_cast<std::uint16_t>(0x8000 + number), PositionEvent{us, static_cast<std::uint16_t>(pos), 0}),
            clock.now());
    }
};

HelloReply honestHello()
{
    return std::get<HelloReply>(ScriptedBoard::honestAnswer(toFrame(1, Hello{}), 0ns));
}

}  // namespace

void BoardTiltStrangersTest::aBoardOfAnotherVersionIsRefused()
{
    Strange rig;
    HelloReply reply = honestHello();
    reply.proto = 2;
    rig.answering<Hello>(reply);

    const auto connected = rig.tilt.connect({});

    QCOMPARE(connected.error().code, ErrorCode::NoDevice);
    QVERIFY(connected.error().message.find("version") != std::string::npos);
}

void BoardTiltStrangersTest::aServoThatCannotBeIsRefused()
{
    for (const auto& change : std::vector<std::function<void(HelloReply&)>>{
             [](HelloReply& r) { r.highest = 0; }, [](HelloReply& r) { r.middle = 1024; },
             [](HelloReply& r) { r.spanMdeg = 0; }, [](HelloReply& r) { r.spanMdeg = 0xFFFFFFFF; }}) {
        Strange rig;
        HelloReply reply = honestHello();
        change(reply);
        rig.answering<Hello>(reply);

        QCOMPARE(rig.tilt.connect({}).error().code, ErrorCode::NoDevice);
    }
}

void BoardTiltStrangersTest::aBoardWithNarrowerLimitsIsRefused()
{
    Strange refuses;
    refuses.answering<SetConfig>(Nak{NakCode::Range, SetConfig::kType, 0});
    QCOMPARE(refuses.tilt.connect({}).error().code, ErrorCode::NoDevice);

    Strange changes;
    changes.answering<SetConfig>(SetConfigReply{});
    const auto connected = changes.tilt.connect({});

    QCOMPARE(connected.error().code, ErrorCode::NoDevice);
    QVERIFY(connected.error().message.find("limits") != std::string::npos);
}

void BoardTiltStrangersTest::aReplyOfAnotherKindIsNone()
{
    Strange rig;
    rig.answering<Hello>(StopReply{});

    QCOMPARE(rig.tilt.connect({}).error().code, ErrorCode::NoDevice);

    QVERIFY(rig.clock.now() >= 2s);
}

void BoardTiltStrangersTest::whatTalksWithoutEndIsNoBoard()
{
    Strange rig;
    rig.board->answer = [](const Frame&, nanoseconds) { return std::nullopt; };
    rig.board->talksWithoutEnd = true;

    QCOMPARE(rig.tilt.connect({}).error().code, ErrorCode::NoDevice);

    QVERIFY(rig.clock.now() < 3s);
}

void BoardTiltStrangersTest::aBoardThatRefusesToBeArmedIsReported()
{
    Strange rig;
    rig.answering<Arm>(Nak{NakCode::State, Arm::kType, 0});
    QVERIFY(rig.tilt.connect({}));

    const auto armed = rig.tilt.arm({});

    QCOMPARE(armed.error().code, ErrorCode::DeviceLost);
    QCOMPARE(rig.tilt.moveTo(degrees(100.0), degrees(20.0)).error().code, ErrorCode::Usage);
}

void BoardTiltStrangersTest::aMoveThatTheBoardRefusesIsReported()
{
    for (const auto& [nak, code] : {std::pair{NakCode::State, ErrorCode::NeedsOperator},
                                    {NakCode::Busy, ErrorCode::DeviceLost},
                                    {NakCode::Estopped, ErrorCode::NeedsOperator},
                                    {NakCode::UnknownType, ErrorCode::DeviceLost},
                                    {NakCode::Range, ErrorCode::Usage}}) {
        Strange rig;
        rig.answering<Move>(Nak{nak, Move::kType, 4});
        QVERIFY(rig.tilt.connect({}));
        QVERIFY(rig.tilt.arm({}));

        QCOMPARE(rig.tilt.moveTo(degrees(100.0), degrees(20.0)).error().code, code);
    }
}

void BoardTiltStrangersTest::eventsThatAreNotKnownAreCountedAndPassedOver()
{
    Strange rig;
    QVERIFY(rig.tilt.connect({}));
    rig.sayPosition(0, rig.clock.now(), 512);
    rig.board->say({0x8001, 0x95, {1, 2, 3}}, rig.clock.now());
    rig.clock.advance(10ms);
    rig.sayPosition(2, rig.clock.now(), 513);

    int samples = 0;
    for (const nanoseconds end = rig.clock.now() + 100ms; rig.clock.now() < end;)
        samples += rig.tilt.sample(end, {}).value() ? 1 : 0;

    QCOMPARE(samples, 2);
    QCOMPARE(rig.tilt.health().lost, std::uint64_t(0));
    QCOMPARE(rig.tilt.health().corrupt, std::uint64_t(0));
}

void BoardTiltStrangersTest::eventsOfTheWrongLengthAreCorrupt()
{
    Strange rig;
    QVERIFY(rig.tilt.connect({}));
    rig.board->say({0x8000, PositionEvent::kType, {1, 2, 3}}, rig.clock.now());

    QVERIFY(!rig.tilt.sample(rig.clock.now() + 50ms, {}).value());

    QCOMPARE(rig.tilt.health().corrupt, std::uint64_t(1));
}

void BoardTiltStrangersTest::anglesWithoutAPossibleTimeAreNone()
{
    Strange rig;
    rig.clock.advance(3600s);
    QVERIFY(rig.tilt.connect({}));
    rig.sayPosition(0, 0ns, 512);
    rig.sayPosition(1, rig.clock.now() + 1200s, 512);
    rig.board->say(toFrame(0x8002, PositionEvent{~std::uint64_t{0}, 512, 0}), rig.clock.now());
    rig.board->say(toFrame(0x8003, SliceEvent{1, std::uint64_t{1} << 63, 512, 0, State::Armed, 0}), rig.clock.now());

    QVERIFY(!rig.tilt.sample(rig.clock.now() + 50ms, {}).value());

    QVERIFY(rig.tilt.takeSliceEvents().empty());
}

void BoardTiltStrangersTest::anglesThatComeOutOfOrderAreDropped()
{
    Strange rig;
    rig.clock.advance(10s);
    QVERIFY(rig.tilt.connect({}));
    const nanoseconds now = rig.clock.now();
    rig.sayPosition(0, now, 512);
    rig.sayPosition(1, now - 20ms, 600);
    rig.sayPosition(2, now, 600);
    rig.sayPosition(3, now + 10ms, 512);

    int samples = 0;
    while (const auto sample = rig.tilt.sample(rig.clock.now() + 20ms, {}).value()) {
        QVERIFY(std::abs(sample->pitch - degrees(90.0)) < 1e-9);
        ++samples;
    }

    QCOMPARE(samples, 2);
    QCOMPARE(rig.tilt.health().corrupt, std::uint64_t(2));
}

/// For 100 ms nothing reaches the board; then the two heartbeats of that time do, and their replies leave one after the
/// other.
void BoardTiltStrangersTest::heartbeatsThatReachTheBoardTogetherAreNoNewStart()
{
    Strange rig;
    rig.clock.advance(10s);
    QVERIFY(rig.tilt.connect({}));
    QVERIFY(rig.tilt.arm({}));
    const nanoseconds from = rig.clock.now() + 500ms;
    const nanoseconds to = from + 100ms;
    int late = 0;
    rig.board->answer = [&](const Frame& frame, nanoseconds now) -> std::optional<Message> {
        if (frame.type == GetStatus::kType) {
            StatusReply status;
            status.state = State::Armed;
            return status;
        }
        if (frame.type != Heartbeat::kType || now < from || now >= to)
            return ScriptedBoard::honestAnswer(frame, now);
        auto reply = std::get<HeartbeatReply>(ScriptedBoard::honestAnswer(frame, to));
        reply.sentUs += static_cast<std::uint64_t>(100 * ++late);
        rig.board->say(toFrame(frame.seq, reply), to + late * 100us);
        return std::nullopt;
    };

    Result<std::optional<TiltSample>> sample = std::nullopt;
    while (sample && rig.clock.now() < to + 20ms)
        sample = rig.tilt.sample(to + 20ms, {});
    rig.sayPosition(0, rig.clock.now(), 512);
    if (sample)
        sample = rig.tilt.sample(rig.clock.now() + 5ms, {});

    QCOMPARE(late, 2);
    QVERIFY2(sample.has_value(), sample ? "" : sample.error().message.c_str());
    QCOMPARE(rig.tilt.health().trouble, std::string());
    // What was known of its clock is kept: half of the 100 us that the quick replies took.
    QVERIFY(*sample);
    QCOMPARE((*sample)->uncertainty, nanoseconds{50us});
}

void BoardTiltStrangersTest::randomMessagesDoNoHarm()
{
    for (unsigned seed = 1; seed <= 30; ++seed) {
        Strange rig;
        QVERIFY(rig.tilt.connect({}));
        QVERIFY(rig.tilt.arm({}));
        std::mt19937 random{seed};
        unsigned number = 0;
        for (int round = 0; round < 200; ++round) {
            for (int i = 0; i < 10; ++i) {
                const bool isEvent = random() % 2 == 0;
                const auto type = static_cast<std::uint8_t>(isEvent ? 0x90 + random() % 6 : 0x41 + random() % 0x3F);
                Frame frame{static_cast<std::uint16_t>(isEvent ? 0x8000U + number++ : random() % 0x400), type, {}};
                frame.payload.resize(random() % 10 == 0 ? random() % 65 : payloadLength(type).value_or(3));
                for (std::uint8_t& byte : frame.payload)
                    byte = static_cast<std::uint8_t>(random() % 4 == 0 ? random() : 0);
                rig.board->say(frame, rig.clock.now());
            }
            const auto sample = rig.tilt.sample(rig.clock.now() + 5ms, {});
            QVERIFY(!sample || !*sample || std::isfinite((*sample)->pitch));
            if (!sample) {
                rig.tilt.hold();
                rig.tilt.arm({});
            }
            rig.tilt.moveTo(degrees(90.0 + round % 50), degrees(20.0));
            rig.tilt.takeSliceEvents();
            rig.tilt.motor();
            QVERIFY(rig.tilt.health().good > 0);
        }
    }
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::BoardTiltStrangersTest)
#include "board_tilt_strangers_test.moc"
