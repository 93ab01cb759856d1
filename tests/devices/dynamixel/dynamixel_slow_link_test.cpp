// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <QRegularExpression>
#include <QtTest>

#include "tests/devices/dynamixel/delayed_servo.h"
#include "tests/devices/dynamixel/servo_rig.h"
#include "tests/test_program.h"

namespace planewright {

using namespace std::chrono_literals;

/// A sound servo behind a link that keeps its answers back: a network, a busy hub, a wrong latency timer.
class DynamixelSlowLinkTest : public QObject {
    Q_OBJECT

private slots:
    void answersThatComeTooLateAreToldWithTheirDelay_data();
    void answersThatComeTooLateAreToldWithTheirDelay();
    void answersThatAreSlowNowAndThenAreNoDamage();
    void aDelayThatIsWaitedForAnywayConnects();
    void aSilentServoIsNoSlowOne();
};

namespace {

using Time = std::chrono::nanoseconds;

struct SlowRig {
    SlowRig(std::uint16_t model, std::vector<Time> delays, std::uint32_t returnLevel = 2)
        : servo(std::make_shared<DelayedServo>(
              EmulatedServo::make(withRegister(emulated(model), model == 1020 ? 68 : 16, returnLevel), {},
                                  [](Time /*now*/) { return 0; })
                  .value(),
              std::move(delays)))
    {
    }
    static DynamixelOptions options()
    {
        DynamixelOptions options;
        options.mounting = ServoRig::kMounting;
        return options;
    }

    FakeClock clock{FakeClock::Kind::Jumps};
    std::shared_ptr<DelayedServo> servo;
    DynamixelTilt tilt{std::make_unique<EmulatedLink>(servo, std::make_shared<std::mutex>(), clock, "bus"), clock,
                       options()};
};

}  // namespace

void DynamixelSlowLinkTest::answersThatComeTooLateAreToldWithTheirDelay_data()
{
    QTest::addColumn<int>("model");
    QTest::addColumn<int>("delay");
    for (const int model : {64, 1020}) {
        for (const int delay : {50, 60, 120, 180, 200, 220, 300, 380})
            QTest::addRow("%d, %d ms", model, delay) << model << delay;
    }
}

void DynamixelSlowLinkTest::answersThatComeTooLateAreToldWithTheirDelay()
{
    QFETCH(int, model);
    QFETCH(int, delay);
    SlowRig rig{static_cast<std::uint16_t>(model), {std::chrono::milliseconds{delay}}};

    const auto connected = rig.tilt.connect({});

    QVERIFY(!connected);
    QCOMPARE(connected.error().code, ErrorCode::NoDevice);
    const QString message = QString::fromStdString(connected.error().message);
    const QRegularExpressionMatch said =
        QRegularExpression{"^bus: servo 1 answers too slowly: (\\d+) ms after a question"}.match(message);
    QVERIFY2(said.hasMatch(), qPrintable(message));
    // Question and answer are at most 25 bytes, which take 4.4 ms, and the servo thinks for half a millisecond.
    QVERIFY2(said.captured(1).toInt() >= delay && said.captured(1).toInt() <= delay + 5, qPrintable(message));
    QVERIFY2(message.contains("latency timer"), qPrintable(message));
    QVERIFY(rig.clock.now() < 4s);
}

void DynamixelSlowLinkTest::answersThatAreSlowNowAndThenAreNoDamage()
{
    for (const std::vector<Time>& delays : std::vector<std::vector<Time>>{{20ms, 80ms}, {80ms, 20ms}, {230ms, 10ms}}) {
        SlowRig rig{64, delays};

        const auto connected = rig.tilt.connect({});

        QVERIFY(!connected);
        QVERIFY2(says(connected.error().message, {"answers too slowly"}), connected.error().message.c_str());
    }
}

void DynamixelSlowLinkTest::aDelayThatIsWaitedForAnywayConnects()
{
    for (const std::uint16_t model : std::initializer_list<std::uint16_t>{64, 1020}) {
        SlowRig rig{model, {30ms}};

        const auto connected = rig.tilt.connect({});

        QVERIFY2(connected, connected ? "" : connected.error().message.c_str());
    }
}

void DynamixelSlowLinkTest::aSilentServoIsNoSlowOne()
{
    for (const std::uint16_t model : std::initializer_list<std::uint16_t>{64, 1020}) {
        SlowRig rig{model, {30ms}, 0};

        const auto connected = rig.tilt.connect({});

        QVERIFY(!connected);
        QVERIFY2(says(connected.error().message, {"status return level is 0"}), connected.error().message.c_str());
    }
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::DynamixelSlowLinkTest)
#include "dynamixel_slow_link_test.moc"
