// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <string>

#include <QtTest>

#include "core/simulation/scene.h"
#include "tests/devices/nodding/emulated_scanner.h"
#include "tests/devices/nodding/scripted_devices.h"
#include "tests/devices/nodding/watched_link.h"
#include "tests/test_program.h"

using namespace std::chrono_literals;

namespace planewright {

/// What a nodding source does between scans.
class NoddingIdleTest : public QObject {
    Q_OBJECT

private slots:
    void devicesAreLookedAfterAndNothingMoves_data();
    void devicesAreLookedAfterAndNothingMoves();
    void theLaserIsAskedNothing();
    void aDeviceThatIsLostIsOpenedAnew_data();
    void aDeviceThatIsLostIsOpenedAnew();
    void aStopEndsTheLookAtOnce();
    void theHeadGoesHomeSlowly_data();
    void theHeadGoesHomeSlowly();
    void nothingGoesHomeAfterAStopOfMotion();
    void aStopOfMotionHoldsWhatGoesHome();
    void aUnitThatHasLostItsPowerWaitsForAPersonAndGoesHomeFirst();
    void aUnitThatHasStartedAnewWhileItsLinkWasAwayWaitsForAPerson_data();
    void aUnitThatHasStartedAnewWhileItsLinkWasAwayWaitsForAPerson();
    void aServoThatHasLostItsPowerWaitsForAPersonAndGoesHomeFirst();
};

namespace {

using IdleTilt = EmulatedRigSetup::Tilt;

ScanPlan idlePlan()
{
    ScanPlan plan;
    plan.firstPitch = degrees(70.0);
    plan.pitchStep = degrees(1.0);
    plan.slices = 10;
    return plan;
}

EmulatedRigSetup idleRig(IdleTilt tilt)
{
    EmulatedRigSetup setup;
    setup.scene = makeScene("corridor", 7).value();
    setup.tilt = tilt;
    setup.startPitch = degrees(60.0);
    return setup;
}

int slicesUntilTheEnd(NoddingSource& source)
{
    int slices = 0;
    for (auto slice = source.next({}); slice && *slice; slice = source.next({}))
        ++slices;
    return slices;
}

void addBothTilts()
{
    QTest::addColumn<IdleTilt>("tilt");
    QTest::newRow("servo") << IdleTilt::Servo;
    QTest::newRow("board") << IdleTilt::Board;
}

bool tellsOf(const NoddingSource& source, const std::string& trouble)
{
    const auto facts = source.health();
    return std::ranges::any_of(
        facts, [&](const HealthFact& fact) { return fact.isTrouble && fact.value.find(trouble) != std::string::npos; });
}

}  // namespace

void NoddingIdleTest::devicesAreLookedAfterAndNothingMoves_data()
{
    addBothTilts();
}

void NoddingIdleTest::devicesAreLookedAfterAndNothingMoves()
{
    QFETCH(IdleTilt, tilt);
    EmulatedScanner emulated(idleRig(tilt));
    const auto source = emulated.open(idlePlan()).value();
    const double begunAt = emulated.rig().pitchAt(emulated.clock().now());
    const std::uint64_t answers = source->deviceHealth().tilt.good;

    for (int look = 0; look < 10; ++look) {
        emulated.clock().advance(500ms);
        const auto begun = emulated.clock().now();
        source->lookAfter({});
        QVERIFY(emulated.clock().now() - begun < 100ms);
    }

    const NoddingHealth health = source->deviceHealth();
    QVERIFY(health.tilt.good >= answers + 10);
    QVERIFY(health.tilt.rate > 0.0);
    QVERIFY(health.motor.temperature);
    QCOMPARE(health.tilt.lost + health.tilt.corrupt + health.tilt.late, std::uint64_t(0));
    QVERIFY2(health.trouble.empty(), health.trouble.c_str());
    QCOMPARE(emulated.rig().pitchAt(emulated.clock().now()), begunAt);
    // What was said meanwhile disturbs no scan.
    QVERIFY(source->begin({}));
    QCOMPARE(slicesUntilTheEnd(*source), 10);
    QVERIFY(source->end());
    source->lookAfter({});
    QVERIFY(source->deviceHealth().trouble.empty());
}

void NoddingIdleTest::theLaserIsAskedNothing()
{
    // A dialogue with it is played again to the byte, and nobody knows how long it was idle.
    EmulatedScanner emulated(idleRig(IdleTilt::Servo));
    int written = 0;
    emulated.wrapLaser = [&](std::unique_ptr<Transport> link) -> std::unique_ptr<Transport> {
        return std::make_unique<WatchedLink>(std::move(link), WatchedLink::OnRead{},
                                             [&](std::span<const std::uint8_t> /*bytes*/) { ++written; });
    };
    const auto source = emulated.open(idlePlan()).value();
    const int before = written;

    source->lookAfter({});

    QVERIFY(before > 0);
    QCOMPARE(written, before);
}

void NoddingIdleTest::aDeviceThatIsLostIsOpenedAnew_data()
{
    QTest::addColumn<bool>("isLaser");
    QTest::newRow("laser") << true;
    QTest::newRow("tilt unit") << false;
}

void NoddingIdleTest::aDeviceThatIsLostIsOpenedAnew()
{
    QFETCH(bool, isLaser);
    DeviceScript script;
    const auto source = NoddingSource::open(scriptedDevices(script), idlePlan(), script.clock, {}).value();
    bool isThere = false;
    const auto unplugged = [&]() -> Result<void> {
        return isThere ? Result<void>{} : fail(ErrorCode::DeviceLost, "the cable is pulled out");
    };
    (isLaser ? script.onLook : script.onSample) = unplugged;

    source->lookAfter({});

    QVERIFY(tellsOf(*source, "the cable is pulled out"));
    QCOMPARE(script.count("unit closed"), isLaser ? 0 : 1);
    QCOMPARE(script.count("laser closed"), 1);  // which of the two has failed is known of a laser alone
    isThere = true;
    source->lookAfter({});
    QVERIFY(!tellsOf(*source, ""));
    QCOMPARE(script.count("arm") + script.count("move") + script.count("laser start"), 0);
    QVERIFY(source->begin({}));
    QCOMPARE(slicesUntilTheEnd(*source), 10);
}

void NoddingIdleTest::aStopEndsTheLookAtOnce()
{
    EmulatedScanner emulated(idleRig(IdleTilt::Board));
    const auto source = emulated.open(idlePlan()).value();
    std::stop_source stop;
    stop.request_stop();
    const auto begun = emulated.clock().now();

    source->lookAfter(stop.get_token());

    QVERIFY(emulated.clock().now() - begun < 20ms);
    QVERIFY(source->deviceHealth().trouble.empty());
}

void NoddingIdleTest::theHeadGoesHomeSlowly_data()
{
    addBothTilts();
}

void NoddingIdleTest::theHeadGoesHomeSlowly()
{
    QFETCH(IdleTilt, tilt);
    EmulatedScanner emulated(idleRig(tilt));
    const auto source = emulated.open(idlePlan()).value();
    const auto begun = emulated.clock().now();

    const auto home = source->goHome({});

    QVERIFY2(home && *home, home ? "" : home.error().message.c_str());
    QVERIFY(std::abs(**home - degrees(90.0)) < degrees(0.6));
    QVERIFY(std::abs(emulated.rig().pitchAt(emulated.clock().now()) - degrees(90.0)) < degrees(0.6));
    // 30° at 20° a second.
    const double seconds = std::chrono::duration<double>(emulated.clock().now() - begun).count();
    QVERIFY2(seconds > 1.4 && seconds < 2.2, qPrintable(QString::number(seconds)));
    // It is held there, and a scan begins from there.
    source->lookAfter({});
    QVERIFY(source->deviceHealth().trouble.empty());
    QVERIFY(source->begin({}));
    QCOMPARE(slicesUntilTheEnd(*source), 10);
}

void NoddingIdleTest::nothingGoesHomeAfterAStopOfMotion()
{
    DeviceScript script;
    const auto source = NoddingSource::open(scriptedDevices(script), idlePlan(), script.clock, {}).value();
    QVERIFY(source->stopMotion());

    const auto refused = source->goHome({});

    QVERIFY(!refused);
    QCOMPARE(refused.error().code, ErrorCode::NeedsOperator);
    QCOMPARE(script.count("arm") + script.count("move"), 0);
    source->release();
    QVERIFY(source->goHome({}));
}

void NoddingIdleTest::aStopOfMotionHoldsWhatGoesHome()
{
    DeviceScript script;
    const auto source = NoddingSource::open(scriptedDevices(script), idlePlan(), script.clock, {}).value();
    QVERIFY(source->begin({}));  // to 70°, less a little way to gain speed
    QVERIFY(source->end());
    const auto begun = script.clock.now();
    script.onTime = [&](auto now) {
        if (now > begun + 300ms && script.count("hold") == 0)
            QVERIFY(source->stopMotion());
    };

    const auto stopped = source->goHome({});

    QVERIFY(!stopped);
    QCOMPARE(stopped.error().code, ErrorCode::Interrupted);
    const double held = script.pitchAt(script.clock.now());
    QVERIFY(held < degrees(80.0));
    QCOMPARE(script.pitchAt(script.clock.now() + 5s), held);
}

void NoddingIdleTest::aUnitThatHasLostItsPowerWaitsForAPersonAndGoesHomeFirst()
{
    DeviceScript script;
    const auto source = NoddingSource::open(scriptedDevices(script), idlePlan(), script.clock, {}).value();
    QVERIFY(source->begin({}));
    QVERIFY(source->next({}).value());
    bool isSilent = true;
    script.onSample = [&]() -> Result<void> {
        return isSilent ? fail(ErrorCode::DeviceLost, "does not answer") : Result<void>{};
    };
    const auto lost = source->next({});
    isSilent = false;
    script.hasTorque = false;  // when it answers again
    const int moves = script.count("move");

    const auto first = source->next({});
    const auto second = source->next({});

    QCOMPARE(lost.error().code, ErrorCode::DeviceLost);
    QCOMPARE(first.error().code, ErrorCode::NeedsOperator);
    QVERIFY2(first.error().message.find("lost its power") != std::string::npos, first.error().message.c_str());
    QCOMPARE(second.error().code, ErrorCode::NeedsOperator);
    QCOMPARE(script.count("move"), moves);
    QCOMPARE(script.count("arm"), 1);
    source->release();
    std::vector<double> goals;
    script.onTime = [&](auto /*now*/) {
        if (script.count("move") > moves + static_cast<int>(goals.size()))
            goals.push_back(toDegrees(script.goal));
    };
    QVERIFY(source->next({}).value());
    QVERIFY(goals.size() >= 2);
    QVERIFY2(std::abs(goals[0] - 90.0) < 0.3, qPrintable(QString::number(goals[0])));
    QVERIFY2(goals[1] < 72.0, qPrintable(QString::number(goals[1])));
    QCOMPARE(slicesUntilTheEnd(*source), 8);
}

void NoddingIdleTest::aUnitThatHasStartedAnewWhileItsLinkWasAwayWaitsForAPerson_data()
{
    QTest::addColumn<int>("uptime");  // at the end of an hour [s], of which the scan was armed half
    QTest::addColumn<bool>("waits");

    QTest::newRow("it has started when the link was lost") << 5 << true;
    QTest::newRow("a minute after it was armed") << 1740 << true;
    QTest::newRow("it runs on") << 3600 << false;
    QTest::newRow("its clock is slow by 0.5 %") << 3582 << false;
    QTest::newRow("its clock is fast by 0.5 %") << 3618 << false;
}

void NoddingIdleTest::aUnitThatHasStartedAnewWhileItsLinkWasAwayWaitsForAPerson()
{
    QFETCH(const int, uptime);
    QFETCH(const bool, waits);
    DeviceScript script;
    script.clock.advance(1h);
    script.startedAt = script.clock.now() - 30min;
    const auto source = NoddingSource::open(scriptedDevices(script), idlePlan(), script.clock, {}).value();
    QVERIFY(source->begin({}));
    QVERIFY(source->next({}).value());
    bool isSilent = true;
    script.onSample = [&]() -> Result<void> {
        return isSilent ? fail(ErrorCode::DeviceLost, "does not answer") : Result<void>{};
    };
    QCOMPARE(source->next({}).error().code, ErrorCode::DeviceLost);
    isSilent = false;
    script.clock.advance(30min);
    script.startedAt = script.clock.now() - std::chrono::seconds{uptime};
    const int moves = script.count("move");

    const auto next = source->next({});

    QCOMPARE(next.has_value(), !waits);
    if (!waits)
        return;
    QCOMPARE(next.error().code, ErrorCode::NeedsOperator);
    QVERIFY2(next.error().message.find("was reset") != std::string::npos, next.error().message.c_str());
    QCOMPARE(script.count("move"), moves);
    source->release();
    QVERIFY(source->next({}).value());
}

/// The whole of it: the power goes in the middle of a scan, the cable stays, the shaft sinks and the power comes back.
void NoddingIdleTest::aServoThatHasLostItsPowerWaitsForAPersonAndGoesHomeFirst()
{
    EmulatedRigSetup setup = idleRig(IdleTilt::Servo);
    setup.faults = {{"servo-power-loss", 15}};
    EmulatedScanner emulated(setup);
    ScanPlan plan = idlePlan();
    plan.slices = 60;
    const auto source = emulated.open(plan).value();
    QVERIFY(source->begin({}));
    QVERIFY(slicesUntilTheEnd(*source) < 60);

    // Whatever is tried without a person: links are opened anew, and nothing moves.
    emulated.clock().advance(2s);
    const double sunk = emulated.rig().pitchAt(emulated.clock().now());
    Result<std::optional<ScanSlice>> next = std::nullopt;
    for (int attempt = 0; attempt < 5; ++attempt) {
        next = source->next({});
        QVERIFY(!next);
        emulated.clock().advance(500ms);
    }
    QCOMPARE(next.error().code, ErrorCode::NeedsOperator);
    QCOMPARE(emulated.rig().pitchAt(emulated.clock().now()), sunk);

    source->release();
    const auto begun = emulated.clock().now();
    QVERIFY(source->next({}).value());
    double highest = 0.0;
    for (auto at = begun; at < emulated.clock().now(); at += 10ms)
        highest = std::max(highest, emulated.rig().pitchAt(at));
    QVERIFY(std::abs(highest - degrees(90.0)) < degrees(0.6));
    QVERIFY(slicesUntilTheEnd(*source) > 30);
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::NoddingIdleTest)
#include "nodding_idle_test.moc"
