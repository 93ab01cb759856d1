// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/dynamixel/dynamixel_bus.h"

#include <random>

#include <QtTest>

#include "devices/dynamixel/dynamixel_tilt.h"
#include "devices/dynamixel/requests.h"
#include "tests/devices/dynamixel/hex_bytes.h"
#include "tests/devices/dynamixel/servo_rig.h"
#include "tests/devices/dynamixel/tampered_servo.h"
#include "tests/test_program.h"

namespace planewright {

using namespace std::chrono_literals;

class DynamixelBusTest : public QObject {
    Q_OBJECT

private slots:
    void aTryEndsWhenItsTimeIsOver_data();
    void aTryEndsWhenItsTimeIsOver();
    void whatCameBeforeIsThrownAway();
    void theMomentOfAMeasurementIsBetweenQuestionAndAnswer();
    void anAnswerOfTheWrongLengthIsNotTaken();
    void aRequestThatMakesNoSenseIsOurOwnFault();
    void aRequestThatTheLineDamagedIsAskedAgain();
    void aPingThatComesBackTheSameIsAnAlarm();
    void twoAnswersToOnePingAreTwoServos();
    void randomBytesAreNoServoAndTakeNoLongTime();
    void whateverAnAnswerHoldsNothingBreaks_data();
    void whateverAnAnswerHoldsNothingBreaks();
};

namespace {

using Bytes = TamperedServo::Bytes;

constexpr DynamixelProtocol kOne = DynamixelProtocol::One;

/// A driver whose servo's answers are changed.
struct TamperedRig {
    explicit TamperedRig(TamperedServo::Tamper tamper, std::uint16_t model = 64)
    {
        auto device = std::make_shared<TamperedServo>(EmulatedServo::make(emulated(model)).value(), std::move(tamper));
        const DynamixelProtocol protocol = model == 64 ? kOne : DynamixelProtocol::Two;
        auto recorded = std::make_unique<RecordedLink>(
            std::make_unique<EmulatedLink>(device, std::make_shared<std::mutex>(), clock, "bus"), clock, protocol);
        link = recorded.get();
        DynamixelOptions options;
        options.mounting = ServoRig::kMounting;
        tilt = std::make_unique<DynamixelTilt>(std::move(recorded), clock, options);
    }

    FakeClock clock;
    RecordedLink* link = nullptr;
    std::unique_ptr<DynamixelTilt> tilt;
};

/// A bus with an emulated servo.
struct Bus {
    explicit Bus(const std::vector<FaultAt>& faults = {}, std::chrono::nanoseconds latency = 0ns)
        : servo(EmulatedServo::make({}, faults).value()),
          link(servo, std::make_shared<std::mutex>(), clock, "bus"),
          bus(link, clock, {1, 57'142, latency})
    {
    }

    FakeClock clock;
    std::shared_ptr<EmulatedServo> servo;
    EmulatedLink link;
    DynamixelBus bus;
};

ServoQuestion stateQuestion()
{
    return {readRequest(kOne, 1, 36, 11), 11, true, false};
}

Bytes withError(Bytes answer, std::uint8_t bits)
{
    answer[4] = static_cast<std::uint8_t>(answer[4] | bits);
    answer.back() = checksum(std::span{answer}.subspan(2, answer.size() - 3));
    return answer;
}

bool isGoalWrite(const Bytes& request)
{
    return request.size() > 6 && request[4] == 0x03 && request[5] == 30;
}

constexpr std::chrono::nanoseconds kByte{std::int64_t{10} * 1'000'000'000 / 57'142};

}  // namespace

void DynamixelBusTest::aTryEndsWhenItsTimeIsOver_data()
{
    QTest::addColumn<int>("latency");
    QTest::newRow("no latency") << 0;
    QTest::newRow("an adapter's 16 ms") << 16;
}

void DynamixelBusTest::aTryEndsWhenItsTimeIsOver()
{
    QFETCH(int, latency);
    Bus bus{{{"servo-silent", 0}}, std::chrono::milliseconds{latency}};
    bus.bus.setReturnDelay(500us);

    const auto reply = bus.bus.ask(stateQuestion());

    QVERIFY(reply->kind == ServoReply::Kind::Silent);
    // Bytes there and back, return delay, twice the latency and 10 ms.
    const auto time = 25 * kByte + 500us + std::chrono::milliseconds{2 * latency} + 10ms;
    QVERIFY(std::chrono::abs(bus.clock.now() - time) < 1us);
}

void DynamixelBusTest::whatCameBeforeIsThrownAway()
{
    Bus bus;
    // A question of a program that is not there any more; its answer has not been read.
    bus.servo->receive(encodePacket(kOne, readRequest(kOne, 1, 0, 11)), 0ns);
    bus.clock.advance(50ms);

    const auto reply = bus.bus.ask(stateQuestion());

    QVERIFY(reply->kind == ServoReply::Kind::Answered);
    QCOMPARE(int(reply->status.data[6]), 148);
    QCOMPARE(bus.bus.health().late, std::uint64_t(1));
}

void DynamixelBusTest::theMomentOfAMeasurementIsBetweenQuestionAndAnswer()
{
    Bus bus;
    bus.clock.advance(1s);

    const auto reply = bus.bus.ask(stateQuestion());

    QVERIFY(reply->asked == 1s);
    QVERIFY(std::chrono::abs(reply->arrived - (1s + 25 * kByte + 500us)) < 1us);
    // Eight bytes after the question began, and half of the 500 µs in which the servo did not speak.
    QVERIFY(std::chrono::abs(reply->measured - (1s + 8 * kByte + 250us)) < 1us);
    QVERIFY(std::chrono::abs(reply->uncertainty - 250us) < 1us);
}

void DynamixelBusTest::anAnswerOfTheWrongLengthIsNotTaken()
{
    Bus bus;
    ServoQuestion question = stateQuestion();
    question.data = 12;

    const auto reply = bus.bus.ask(question);

    QVERIFY(reply->kind == ServoReply::Kind::Damaged);
    QCOMPARE(reply->answers, 0);
}

void DynamixelBusTest::aRequestThatMakesNoSenseIsOurOwnFault()
{
    for (const int bits : {0x02, 0x08, 0x40}) {
        bool isBad = false;
        TamperedRig rig{[&](const Bytes& request, Bytes answer) {
            return isBad && isGoalWrite(request) ? withError(std::move(answer), static_cast<std::uint8_t>(bits))
                                                 : answer;
        }};
        QVERIFY(rig.tilt->connect({}));
        QVERIFY(rig.tilt->arm({}));
        rig.link->forget();
        isBad = true;

        const auto moved = rig.tilt->moveTo(degrees(10.0), degrees(66.6));

        QVERIFY(!moved);
        QCOMPARE(moved.error().code, ErrorCode::Internal);
        // 34 counts over the middle at 100 units.
        QVERIFY2(says(moved.error().message, {"FF FF 01 07 03 1E 22 02 64 00 4E", "report"}),
                 moved.error().message.c_str());
        QCOMPARE(rig.link->written().size(), std::size_t(1));
        QVERIFY(!rig.tilt->moveTo(degrees(10.0), degrees(66.6)));
        QCOMPARE(rig.link->written().size(), std::size_t(1));
    }
}

void DynamixelBusTest::aRequestThatTheLineDamagedIsAskedAgain()
{
    int damaged = 0;
    TamperedRig rig{[&](const Bytes& request, Bytes answer) {
        return isGoalWrite(request) && damaged-- > 0 ? withError(std::move(answer), 0x10) : answer;
    }};
    QVERIFY(rig.tilt->connect({}));
    QVERIFY(rig.tilt->arm({}));

    damaged = 2;
    QVERIFY(rig.tilt->moveTo(degrees(10.0), 1.0));
    damaged = 3;
    const auto moved = rig.tilt->moveTo(degrees(20.0), 1.0);
    QVERIFY(!moved);
    QCOMPARE(moved.error().code, ErrorCode::Internal);
    QVERIFY(says(moved.error().message, {"wrong checksum"}));
}

void DynamixelBusTest::aPingThatComesBackTheSameIsAnAlarm()
{
    // The supply is out of range: FF FF 01 02 01 FB is the ping and its answer.
    Bus bus{{{"servo-voltage", 0}}};

    const auto reply = bus.bus.ask({pingRequest(1), std::nullopt, true, true});

    QVERIFY(reply->kind == ServoReply::Kind::Answered);
    QCOMPARE(reply->answers, 1);
    QCOMPARE(int(reply->status.error), 0x01);
    ServoRig rig{{}, {{"servo-voltage", 0}}};
    QVERIFY(rig.tilt->connect({}));
    QVERIFY(says(rig.tilt->motor().trouble, {"supply voltage"}));
}

void DynamixelBusTest::twoAnswersToOnePingAreTwoServos()
{
    // Their return delays differ by so much that both can be heard.
    TamperedRig rig{[](const Bytes& request, Bytes answer) {
        if (request[4] == 0x01)
            answer.insert(answer.end(), answer.begin(), answer.end());
        return answer;
    }};

    const auto connected = rig.tilt->connect({});

    QVERIFY(!connected);
    QCOMPARE(connected.error().code, ErrorCode::NoDevice);
    QVERIFY(says(connected.error().message, {"two servos answer", "one at a time"}));
}

namespace {

/// Speaks without end and without sense.
class Noise : public EmulatedDevice {
public:
    explicit Noise(std::uint32_t seed) : random_(seed) {}

    void receive(std::span<const std::uint8_t> /*bytes*/, std::chrono::nanoseconds /*now*/) override {}
    std::vector<EmulatedOutput> takeOutput(std::chrono::nanoseconds now) override
    {
        std::vector<EmulatedOutput> outputs;
        for (; next_ <= now; next_ += 5ms) {
            Bytes bytes;
            for (int i = 0; i < 40; ++i)
                bytes.push_back(static_cast<std::uint8_t>(random_() % 4 == 0 ? random_() : 0xFF));
            outputs.push_back({next_, bytes});
        }
        return outputs;
    }
    std::optional<std::chrono::nanoseconds> nextOutput() const override { return next_; }
    bool isConnected(std::chrono::nanoseconds /*now*/) override { return true; }

private:
    std::mt19937 random_;
    std::chrono::nanoseconds next_{0};
};

}  // namespace

void DynamixelBusTest::randomBytesAreNoServoAndTakeNoLongTime()
{
    for (std::uint32_t seed = 1; seed <= 20; ++seed) {
        FakeClock clock;
        DynamixelOptions options;
        options.mounting = ServoRig::kMounting;
        DynamixelTilt tilt{
            std::make_unique<EmulatedLink>(std::make_shared<Noise>(seed), std::make_shared<std::mutex>(), clock, "bus"),
            clock, options};

        const auto connected = tilt.connect({});

        QVERIFY(!connected);
        QCOMPARE(connected.error().code, ErrorCode::NoDevice);
        // Two pings in each protocol, which listen for 195 ms; then 0.4 s of quiet, and one more in each for 445 ms.
        QVERIFY(clock.now() < 2200ms);
    }
}

void DynamixelBusTest::whateverAnAnswerHoldsNothingBreaks_data()
{
    QTest::addColumn<int>("model");
    QTest::addColumn<int>("goalAddress");
    QTest::addColumn<int>("speedAddress");
    QTest::newRow("RX-64") << 64 << 30 << 32;
    QTest::newRow("XM430") << 1020 << 116 << 112;
}

void DynamixelBusTest::whateverAnAnswerHoldsNothingBreaks()
{
    // Sound packets of any content: an error or a sample, and never a motion beyond the limits.
    QFETCH(int, model);
    QFETCH(int, goalAddress);
    QFETCH(int, speedAddress);
    std::mt19937 random{5};  // NOLINT: the same bytes every time
    for (int round = 0; round < 300; ++round) {
        const DynamixelProtocol protocol = model == 64 ? kOne : DynamixelProtocol::Two;
        bool isBad = false;
        TamperedRig rig{[&](const Bytes& /*request*/, Bytes answer) {
                            const auto packets = PacketParser{protocol}.push(answer);
                            if (!isBad || packets.size() != 1 || random() % 4 == 0)
                                return answer;
                            DynamixelStatus status = statusOf(protocol, packets[0]).value();
                            for (std::uint8_t& byte : status.data)
                                byte = static_cast<std::uint8_t>(random());
                            if (random() % 8 == 0)
                                status.error = static_cast<std::uint8_t>(random());
                            return encodePacket(protocol, packetOf(protocol, status));
                        },
                        static_cast<std::uint16_t>(model)};
        isBad = round % 3 == 0;
        (void)rig.tilt->connect({});
        (void)rig.tilt->arm({});
        isBad = true;
        for (int i = 0; i < 10; ++i) {
            (void)rig.tilt->moveTo(rig.tilt->lowest(), rig.tilt->fastest());
            (void)rig.tilt->sample(rig.clock.now() + 50ms, {});
        }
        (void)rig.tilt->hold();
        (void)rig.tilt->recover({});
        for (const WrittenRequest& request : rig.link->written()) {
            const std::size_t width = model == 64 ? 1 : 2;
            const std::size_t size = 2 * width;
            const std::span<const std::uint8_t> parameters{request.packet.parameters};
            if (request.packet.code != 0x03)
                continue;
            const auto first = fromLittleEndian(parameters.first(width));
            const auto valueAt = [&](int address) {
                return fromLittleEndian(parameters.subspan(width + static_cast<std::size_t>(address) - first, size));
            };
            const std::size_t end = first + parameters.size() - width;
            if (std::size_t(goalAddress) >= first && std::size_t(goalAddress) + size <= end)
                QVERIFY(valueAt(goalAddress) <= (model == 64 ? 1023U : 4095U));
            if (std::size_t(speedAddress) >= first && std::size_t(speedAddress) + size <= end)
                QVERIFY(valueAt(speedAddress) >= 1);
        }
        QVERIFY(rig.clock.now() < 60s);
    }
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::DynamixelBusTest)
#include "dynamixel_bus_test.moc"
