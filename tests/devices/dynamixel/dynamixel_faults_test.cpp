// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <QtTest>

#include "devices/dynamixel/requests.h"
#include "tests/devices/dynamixel/moving_servo.h"
#include "tests/test_program.h"

namespace planewright {

using namespace std::chrono_literals;

class DynamixelFaultsTest : public QObject {
    Q_OBJECT

private slots:
    void whatDoesNotMoveIsToldTwiceAndThenHeld_data();
    void whatDoesNotMoveIsToldTwiceAndThenHeld();
    void onlyAnglesThatWereMeasuredAreGiven_data();
    void onlyAnglesThatWereMeasuredAreGiven();
    void anAlarmEndsTheMotionAndNamesItsNumbers_data();
    void anAlarmEndsTheMotionAndNamesItsNumbers();
    void anAlarmAtConnectIsSeenBeforeAnythingMoves();
    void aRefusedRequestIsLoggedAndEndsTheMotion_data();
    void aRefusedRequestIsLoggedAndEndsTheMotion();
    void silenceAndDamageAreLogged();
    void silenceIsToldAfterThreeTries_data();
    void silenceIsToldAfterThreeTries();
    void lostBytesAreAskedForAgain();
    void whatAnswersWronglyIsRefusedAtConnect_data();
    void whatAnswersWronglyIsRefusedAtConnect();
    void anEchoThatIsKnownIsLeftOut();
    void anEchoDoesNotKeepItFromHolding();
    void aServoThatHasLostItsPowerIsArmedAgainFirst();
    void powerLostBetweenQuestionsIsSeen();
    void anAngleThatCannotBeIsNotGiven();
    void lateAnswersAreNoSamplesOfAMovingServo();
    void answersToEarlierQuestionsAreNotTaken();
    void aPulledCableIsGone();
    void theReactionIsTheSameInEveryRun();
};

void DynamixelFaultsTest::whatDoesNotMoveIsToldTwiceAndThenHeld_data()
{
    QTest::addColumn<QString>("fault");
    QTest::addColumn<QString>("load");
    QTest::newRow("something blocks it") << "servo-stall"
                                         << "load 100 %";
    QTest::newRow("it acknowledges and stands") << "servo-frozen"
                                                << "load 6 %";
}

void DynamixelFaultsTest::whatDoesNotMoveIsToldTwiceAndThenHeld()
{
    QFETCH(QString, fault);
    QFETCH(QString, load);
    Moving rig{fault.toStdString()};
    const double there = rig.truth(rig.clock.now());

    const auto arrived = rig.arrive();

    QVERIFY(!arrived);
    QCOMPARE(arrived.error().code, ErrorCode::NeedsOperator);
    VERIFY_SAYS(arrived.error().message, {"servo 1 is stuck", "60.1°", load.toStdString(), "14.8 V", "38 °C"});
    QCOMPARE(rig.tilt->motor().trouble, arrived.error().message);
    // No progress for 300 ms, told again, 300 ms more.
    const auto took = rig.clock.now() - rig.began;
    QVERIFY(took > 600ms && took < 700ms);
    const auto writes = rig.writes();
    QCOMPARE(writes.size(), std::size_t(2));
    QCOMPARE(writes[0].parameters.size(), std::size_t(5));  // goal and speed once more
    QCOMPARE(writes[1].parameters.size(), std::size_t(3));  // goal := where it is
    const double goal =
        (double(fromLittleEndian(std::span{writes[1].parameters}.subspan(1))) - 512) * degrees(300.0 / 1023.0);
    QVERIFY(std::abs(goal - there) < degrees(0.3));
    QCOMPARE(rig.tilt->moveTo(0.0, 1.0).error().code, ErrorCode::NeedsOperator);
    VERIFY_DONE(rig.tilt->arm({}));
    QVERIFY(rig.tilt->motor().trouble.empty());
}

void DynamixelFaultsTest::onlyAnglesThatWereMeasuredAreGiven_data()
{
    QTest::addColumn<QString>("fault");
    for (const ServoFaultKind& kind : servoFaultKinds())
        QTest::newRow(std::string{kind.kind}.c_str()) << QString::fromStdString(std::string{kind.kind});
}

void DynamixelFaultsTest::onlyAnglesThatWereMeasuredAreGiven()
{
    // Whatever goes wrong: no sample tells of a place where the shaft was not, and no call hangs.
    QFETCH(QString, fault);
    for (const std::uint64_t seed : {1U, 2U, 3U, 4U, 5U}) {
        EmulatedServoSettings settings;
        settings.seed = seed;
        Moving rig{fault.toStdString(), settings};
        for (int i = 0; i < 300; ++i) {
            const auto began = rig.clock.now();
            const auto sample = rig.sample(100ms);
            QVERIFY(rig.clock.now() - began < 300ms);
            if (!sample) {
                QVERIFY(sample.error().message.find("bus: ") == 0);
                if (i > 100)
                    break;
                continue;
            }
            // A late answer has no sharp moment: half of 30 ms, while it is slower than 61°/s.
            const double bound = fault == "servo-slow" ? degrees(1.2) : degrees(0.2);
            if (*sample && fault != "servo-wrong-angle")
                QVERIFY(std::abs((*sample)->pitch - rig.truth((*sample)->at)) < bound);
        }
    }
}

void DynamixelFaultsTest::anAlarmEndsTheMotionAndNamesItsNumbers_data()
{
    QTest::addColumn<int>("model");
    QTest::addColumn<QString>("fault");
    QTest::addColumn<QString>("words");

    for (const int model : {64, 1020}) {
        const char* name = model == 64 ? "RX-64" : "XM430";
        QTest::addRow("%s overload", name) << model << "servo-overload"
                                           << "(overload)|load 100 %|turned itself off";
        QTest::addRow("%s overheat", name) << model << "servo-overheat"
                                           << "(overheating)|82 °C (limit 80)|turned itself off";
        QTest::addRow("%s voltage", name) << model << "servo-voltage"
                                          << "(supply voltage out of range)|5.8 V (allowed |told to stay";
    }
}

void DynamixelFaultsTest::anAlarmEndsTheMotionAndNamesItsNumbers()
{
    QFETCH(int, model);
    QFETCH(QString, fault);
    QFETCH(QString, words);
    Moving rig{fault.toStdString(), emulated(static_cast<std::uint16_t>(model))};

    const auto sample = rig.sample();

    QVERIFY(!sample);
    QCOMPARE(sample.error().code, ErrorCode::NeedsOperator);
    for (const QString& word : words.split('|'))
        VERIFY_SAYS(sample.error().message, {word.toStdString()});
    QCOMPARE(rig.tilt->motor().trouble, sample.error().message);
    QCOMPARE(rig.tilt->health().trouble, sample.error().message);
    // It stands, and nobody turns its torque on again.
    const double there = rig.truth(rig.clock.now());
    QVERIFY(there < degrees(10.0));
    QVERIFY(std::abs(rig.truth(rig.clock.now() + 1s) - there) < degrees(2.0));
    for (int i = 0; i < 20; ++i)
        QVERIFY(!rig.sample());
    QVERIFY(!rig.tilt->moveTo(0.0, 1.0));
    QVERIFY(!rig.tilt->arm({}));
    QCOMPARE(rig.tilt->moveTo(0.0, 1.0).error().code, ErrorCode::NeedsOperator);
    for (const DynamixelPacket& write : rig.writes())
        QVERIFY(write.parameters[0] == (model == 64 ? 30 : 116));  // at most the goal, where it is
    QVERIFY(rig.writes().size() <= 1);
}

void DynamixelFaultsTest::anAlarmAtConnectIsSeenBeforeAnythingMoves()
{
    for (const char* fault : {"servo-overload", "servo-overheat", "servo-voltage"}) {
        ServoRig rig{{}, {{fault, 0}}};

        VERIFY_DONE(rig.tilt->connect({}));

        VERIFY_SAYS(rig.tilt->motor().trouble, {"alarm"});
        const auto armed = rig.tilt->arm({});
        QVERIFY(!armed);
        QCOMPARE(armed.error().code, ErrorCode::NeedsOperator);
        for (const WrittenRequest& request : rig.link->written())
            QVERIFY(request.packet.code != kWrite);
    }
}

void DynamixelFaultsTest::aRefusedRequestIsLoggedAndEndsTheMotion_data()
{
    QTest::addColumn<int>("model");
    QTest::addColumn<QString>("fault");
    QTest::addColumn<QString>("words");
    for (const int model : {64, 1020}) {
        const auto row = [&](const char* fault, const char* one, const char* two) {
            QTest::addRow("%s of %d", fault, model) << model << fault << (model == 64 ? one : two);
        };
        row("servo-angle-bit", "beyond the angle limits", "beyond a limit");
        row("servo-range-bit", "out of range", "out of range");
        row("servo-checksum-bit", "wrong checksum", "wrong CRC");
        row("servo-instruction-bit", "unknown instruction", "unknown instruction");
    }
}

void DynamixelFaultsTest::aRefusedRequestIsLoggedAndEndsTheMotion()
{
    QFETCH(int, model);
    QFETCH(QString, fault);
    QFETCH(QString, words);
    Moving rig{fault.toStdString(), emulated(static_cast<std::uint16_t>(model))};

    const auto sample = rig.sample();

    QVERIFY(!sample);
    QCOMPARE(sample.error().code, ErrorCode::Internal);
    VERIFY_SAYS(sample.error().message, {words.toStdString(), "please report this line"});
    const std::vector<FaultRecord> log = rig.tilt->takeLog();
    QCOMPARE(log.size(), std::size_t(1));
    QCOMPARE(log[0].code, std::string{"servo-refused"});
    VERIFY_SAYS(log[0].text, {words.toStdString()});
    QVERIFY(log[0].bytes.starts_with("FF FF "));  // the request
    QVERIFY(sample.error().message.find(log[0].bytes) != std::string::npos);
    QVERIFY(!rig.tilt->moveTo(0.0, 1.0));
}

void DynamixelFaultsTest::silenceAndDamageAreLogged()
{
    Moving silent{"servo-silent"};
    QVERIFY(!silent.sample());
    std::vector<FaultRecord> log = silent.tilt->takeLog();
    QCOMPARE(log.size(), std::size_t(3));  // three tries
    QCOMPARE(log[0].code, std::string{"servo-silent"});
    QCOMPARE(log[0].bytes, std::string{"FF FF 01 04 02 24 0B C9"});  // the question for the state
    QCOMPARE(silent.tilt->health().faults.at("servo-silent"), std::uint64_t(3));

    Moving hot{"servo-overheat"};
    QVERIFY(!hot.sample());
    log = hot.tilt->takeLog();
    QCOMPARE(log.size(), std::size_t(1));
    QCOMPARE(log[0].code, std::string{"servo-alarm"});
    QVERIFY2(log[0].bytes.starts_with("FF FF 01 0D 04 "), log[0].bytes.c_str());  // its answer, with bit 2
    QVERIFY(!hot.sample());
    QVERIFY(hot.tilt->takeLog().empty());  // the same alarm is no news
}

void DynamixelFaultsTest::silenceIsToldAfterThreeTries_data()
{
    QTest::addColumn<QString>("fault");
    QTest::addColumn<QString>("words");
    QTest::newRow("nothing comes") << "servo-silent"
                                   << "does not answer|plug";
    QTest::newRow("every answer is damaged") << "servo-garbled"
                                             << "damaged|two servos";
    QTest::newRow("another one answers") << "servo-wrong-id"
                                         << "number 7 answers in its place";
    QTest::newRow("two answer at once") << "servo-two"
                                        << "damaged|two servos";
    QTest::newRow("our own bytes come back") << "servo-echo"
                                             << "sends back what is sent|echo off";
}

void DynamixelFaultsTest::silenceIsToldAfterThreeTries()
{
    QFETCH(QString, fault);
    QFETCH(QString, words);
    DynamixelOptions options;
    options.latency = 1ms;
    Moving rig{fault.toStdString(), {}, options};

    const auto sample = rig.sample();

    QVERIFY(!sample);
    QCOMPARE(sample.error().code, ErrorCode::DeviceLost);
    for (const QString& word : words.split('|'))
        VERIFY_SAYS(sample.error().message, {word.toStdString()});
    // Up to 27 bytes, 0.5 ms, twice 1 ms and 10 ms, three times.
    QVERIFY(rig.clock.now() - rig.began < 3 * 17'400us);
    const bool isEcho = fault == "servo-echo";
    QCOMPARE(rig.link->written().size(), std::size_t(isEcho ? 1 : 3));
    QCOMPARE(rig.tilt->health().lost + rig.tilt->health().corrupt, std::uint64_t(isEcho ? 0 : 3));
    QCOMPARE(rig.tilt->moveTo(0.0, 1.0).error().code, ErrorCode::DeviceLost);
    QVERIFY(!rig.tilt->health().trouble.empty());
}

void DynamixelFaultsTest::lostBytesAreAskedForAgain()
{
    // A byte of 1000 gets lost, and each round trip has 25: one of 40 fails.
    Moving rig{"servo-byte-loss"};
    int samples = 0;
    for (int i = 0; i < 2000; ++i) {
        const auto sample = rig.sample();
        QVERIFY2(sample, sample ? "" : sample.error().message.c_str());
        if (!*sample)
            continue;
        ++samples;
        QVERIFY(std::abs((*sample)->pitch - rig.truth((*sample)->at)) < degrees(0.2));
    }

    QCOMPARE(samples, 2000);
    const LinkHealth health = rig.tilt->health();
    QVERIFY(health.lost + health.corrupt > 20);
    QVERIFY(health.lost + health.corrupt < 100);
}

void DynamixelFaultsTest::whatAnswersWronglyIsRefusedAtConnect_data()
{
    QTest::addColumn<QString>("fault");
    QTest::addColumn<int>("model");
    QTest::addColumn<QString>("words");
    for (const int model : {64, 1020}) {
        const char* name = model == 64 ? "RX-64" : "XM430";
        QTest::addRow("%s silent", name) << "servo-silent" << model << "does not answer at|power";
        QTest::addRow("%s garbled", name) << "servo-garbled" << model << "damaged|cable";
        QTest::addRow("%s wrong number", name) << "servo-wrong-id" << model << "number 7 answers in its place";
        QTest::addRow("%s two", name) << "servo-two" << model << "two servos|connect one servo alone";
        QTest::addRow("%s echo", name) << "servo-echo" << model << "sends back what is sent|echo=yes";
        QTest::addRow("%s wheel", name) << "servo-wheel" << model << "connect again";
    }
}

void DynamixelFaultsTest::whatAnswersWronglyIsRefusedAtConnect()
{
    QFETCH(QString, fault);
    QFETCH(int, model);
    QFETCH(QString, words);
    ServoRig rig{emulated(static_cast<std::uint16_t>(model)), {{fault.toStdString(), 0}}};

    const auto connected = rig.tilt->connect({});

    QVERIFY(!connected);
    QCOMPARE(connected.error().code, ErrorCode::NoDevice);
    for (const QString& word : words.split('|'))
        VERIFY_SAYS(connected.error().message, {word.toStdString()});
    QVERIFY(!rig.tilt->arm({}));
    for (const WrittenRequest& request : rig.link->written())
        QVERIFY(request.packet.code != kWrite);
}

void DynamixelFaultsTest::anEchoThatIsKnownIsLeftOut()
{
    DynamixelOptions options;
    options.dropEcho = true;
    for (const std::uint16_t model : std::initializer_list<std::uint16_t>{64, 1020}) {
        ServoRig rig{emulated(model), {{"servo-echo", 0}}, options};
        VERIFY_DONE(rig.ready());
        VERIFY_DONE(rig.tilt->moveTo(degrees(10.0), 1.0));
        const auto arrived = rig.arrive();
        QVERIFY(arrived);
        QVERIFY(std::abs(arrived->pitch - degrees(10.0)) < degrees(0.15));
        QCOMPARE(rig.tilt->health().late + rig.tilt->health().corrupt, std::uint64_t(0));
    }
    // An adapter that sends everything back, and no servo behind it.
    ServoRig alone{{}, {{"servo-echo", 0}, {"servo-silent", 0}}, options};
    const auto connected = alone.tilt->connect({});
    QVERIFY(!connected);
    VERIFY_SAYS(connected.error().message, {"does not answer", "sends back", "power"});
}

void DynamixelFaultsTest::anEchoDoesNotKeepItFromHolding()
{
    Moving rig{"servo-echo"};

    VERIFY_DONE(rig.tilt->hold());

    QVERIFY(std::abs(rig.truth(rig.clock.now() + 2s)) < degrees(2.0));
}

void DynamixelFaultsTest::aServoThatHasLostItsPowerIsArmedAgainFirst()
{
    for (const std::uint16_t model : std::initializer_list<std::uint16_t>{64, 1020}) {
        Moving rig{"servo-power-loss", emulated(model)};
        const auto silent = rig.sample();
        QVERIFY(!silent);
        VERIFY_SAYS(silent.error().message, {"does not answer"});
        QVERIFY(!rig.tilt->moveTo(degrees(10.0), 1.0));
        rig.clock.advance(1s);

        const auto back = rig.sample();

        QVERIFY(!back);
        // A link that is tried again by itself must not move what somebody may have in his hands.
        QCOMPARE(back.error().code, ErrorCode::NeedsOperator);
        VERIFY_SAYS(back.error().message, {"lost its power", "home first"});
        QVERIFY(!rig.tilt->holdsItself());
        QCOMPARE(rig.tilt->moveTo(degrees(10.0), 1.0).error().code, ErrorCode::NeedsOperator);
        const auto sunk = rig.sample().value().value();
        QVERIFY(sunk.pitch < degrees(-10.0));
        QVERIFY(std::abs(sunk.pitch - rig.truth(sunk.at)) < degrees(0.2));
        VERIFY_DONE(rig.tilt->arm({}));
        QVERIFY(rig.tilt->holdsItself());
        QVERIFY(std::abs(rig.truth(rig.clock.now() + 1s) - sunk.pitch) < degrees(0.3));
        VERIFY_DONE(rig.tilt->moveTo(degrees(10.0), 1.0));
        VERIFY_DONE(rig.arrive());
    }
}

void DynamixelFaultsTest::powerLostBetweenQuestionsIsSeen()
{
    // Nobody asks while the power goes and comes: the next sample sees it, and so does the next motion.
    for (const bool isMotion : {false, true}) {
        Moving rig{"servo-power-loss"};
        rig.truth(rig.clock.now());
        rig.clock.advance(1200ms);

        const auto sample = isMotion ? Result<std::optional<TiltSample>>{std::nullopt} : rig.sample();
        const auto moved = rig.tilt->moveTo(degrees(10.0), 1.0);

        QVERIFY(!moved);
        QCOMPARE(moved.error().code, ErrorCode::NeedsOperator);
        VERIFY_SAYS(moved.error().message, {"lost its power"});
        QCOMPARE(sample.has_value(), isMotion);
        QVERIFY(rig.writes().empty());
    }
}

void DynamixelFaultsTest::anAngleThatCannotBeIsNotGiven()
{
    for (const std::uint64_t seed : {1U, 2U, 3U, 4U}) {
        EmulatedServoSettings settings;
        settings.seed = seed;
        Moving rig{"servo-wrong-angle", settings};

        const auto sample = rig.sample();

        QVERIFY(!sample);
        QCOMPARE(sample.error().code, ErrorCode::DeviceLost);
        VERIFY_SAYS(sample.error().message, {"says that it has turned by", "which it cannot"});
        // It is told to stay at the last place that could be true, and a hold says the same again.
        const double there = rig.truth(rig.clock.now() + 1s);
        QVERIFY(std::abs(there) < degrees(1.5));
        VERIFY_DONE(rig.tilt->hold());
        QVERIFY(std::abs(rig.truth(rig.clock.now() + 3s) - there) < degrees(0.01));
    }
}

void DynamixelFaultsTest::lateAnswersAreNoSamplesOfAMovingServo()
{
    Moving rig{"servo-slow"};
    int given = 0;
    while (rig.clock.now() - rig.began < 900ms) {
        const auto sample = rig.sample(200ms);
        QVERIFY(sample);
        given += sample->has_value() ? 1 : 0;
    }

    QCOMPARE(given, 0);
    const LinkHealth health = rig.tilt->health();
    QVERIFY(health.late > 10);
    QCOMPARE(health.lost, std::uint64_t(0));
    VERIFY_SAYS(health.trouble, {"ms late", "latency timer"});
    // At rest the moment does not matter.
    const auto arrived = rig.arrive();
    QVERIFY(arrived);
    QVERIFY(std::abs(arrived->pitch - degrees(60.0)) < degrees(0.2));
}

void DynamixelFaultsTest::answersToEarlierQuestionsAreNotTaken()
{
    // Answers come 20 to 30 ms late and are waited for 15 ms: each is there when the next question is under way.
    DynamixelOptions options;
    options.latency = 0ms;
    Moving rig{"servo-slow", {}, options};

    for (int i = 0; i < 20; ++i) {
        const auto sample = rig.sample();
        if (sample && *sample)
            QVERIFY(std::abs((*sample)->pitch - rig.truth((*sample)->at)) < degrees(0.2));
        else
            QVERIFY(!sample);
    }
    QVERIFY(rig.tilt->health().lost + rig.tilt->health().corrupt > 10);
}

void DynamixelFaultsTest::aPulledCableIsGone()
{
    Moving rig{"servo-unplug"};

    const auto sample = rig.sample();

    QVERIFY(!sample);
    QCOMPARE(sample.error().code, ErrorCode::DeviceLost);
    VERIFY_SAYS(sample.error().message, {"gone"});
    QVERIFY(rig.clock.now() - rig.began < 20ms);
    QCOMPARE(rig.tilt->hold().error().code, ErrorCode::DeviceLost);
    QCOMPARE(rig.tilt->connect({}).error().code, ErrorCode::DeviceLost);
    // Nobody stops it: it goes to its goal and stands there.
    QVERIFY(std::abs(rig.truth(rig.clock.now() + 3s) - degrees(60.0)) < degrees(0.2));
}

void DynamixelFaultsTest::theReactionIsTheSameInEveryRun()
{
    const auto run = [] {
        Moving rig{"servo-byte-loss"};
        std::string log;
        for (int i = 0; i < 300; ++i) {
            const auto sample = rig.sample().value();
            log += std::to_string(sample->at.count()) + " " + std::to_string(sample->pitch) + "\n";
        }
        return log;
    };
    QCOMPARE(run(), run());
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::DynamixelFaultsTest)
#include "dynamixel_faults_test.moc"
