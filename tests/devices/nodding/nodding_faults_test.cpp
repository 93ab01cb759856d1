// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <map>
#include <optional>

#include <QtTest>

#include "core/simulation/nodding_scanner.h"
#include "core/simulation/random.h"
#include "tests/devices/nodding/emulated_scanner.h"
#include "tests/devices/nodding/faulty_link.h"
#include "tests/devices/nodding/watched_link.h"
#include "tests/sanitized.h"
#include "tests/test_program.h"

using namespace std::chrono_literals;

namespace planewright {

/// Whatever goes wrong, a nodding source ends or goes on, and what it gives was measured.
class NoddingFaultsTest : public QObject {
    Q_OBJECT

private slots:
    void everyFaultOfADeviceEndsOrHeals_data();
    void everyFaultOfADeviceEndsOrHeals();
    void wrongAnglesAreNoticed_data();
    void wrongAnglesAreNoticed();
    void aFaultOfTheCableHeals_data();
    void aFaultOfTheCableHeals();
};

namespace {

using Tilt = EmulatedRigSetup::Tilt;
using Mode = ScanPlan::Mode;
using Time = std::chrono::nanoseconds;

/// A call that connects anew takes most of what there is for going on again.
constexpr Time kRecovery = 3s;
/// Whoever waits longer for a call than this asks it to stop, and is answered in that time.
constexpr Time kPatience = 2s;
constexpr int kSlices = 40;

Scene room()
{
    static const Scene scene = makeScene("corridor", 7).value();
    return scene;
}

ScanPlan faultsPlan(Mode mode)
{
    ScanPlan plan;
    plan.mode = mode;
    plan.firstPitch = degrees(60.0);
    plan.slices = kSlices;
    plan.firstBearing = degrees(60.0);
    plan.lastBearing = degrees(120.0);
    return plan;
}

/// What a scan came to: somebody sits there and says "try again" 0.4 s after every failure.
struct Outcome {
    std::vector<ScanSlice> slices;
    std::vector<Error> errors;
    Time longest{0};              ///< call
    Time longestToStop{0};        ///< from a stop after kPatience of a call to its end
    std::optional<Time> resumed;  ///< first slice at or behind a moment
    bool isComplete = false;
    bool wasAsked = false;  ///< for a slice
};

/// Asks a call to stop that takes longer than kPatience. All links have to be watched.
class Impatience {
public:
    explicit Impatience(EmulatedScanner& emulated) : emulated_(emulated)
    {
        const auto watched = [this](const EmulatedScanner::Wrap& inner) {
            return [this, inner](std::unique_ptr<Transport> link) -> std::unique_ptr<Transport> {
                return std::make_unique<WatchedLink>(inner ? inner(std::move(link)) : std::move(link),
                                                     [this] { look(); });
            };
        };
        emulated.wrapLaser = watched(emulated.wrapLaser);
        emulated.wrapTilt = watched(emulated.wrapTilt);
    }

    /// A call begins.
    std::stop_token begin()
    {
        stop_ = {};
        stoppedAt_.reset();
        begunAt_ = emulated_.clock().now();
        return stop_.get_token();
    }
    /// The call is over: how long that took since it was asked to stop.
    Time sinceStop() const { return stoppedAt_ ? emulated_.clock().now() - *stoppedAt_ : Time{0}; }
    bool hasStopped() const { return stoppedAt_.has_value(); }

private:
    void look()
    {
        const Time now = emulated_.clock().now();
        if (stoppedAt_ || now < begunAt_ + kPatience)
            return;
        stoppedAt_ = now;
        stop_.request_stop();
    }

    EmulatedScanner& emulated_;
    std::stop_source stop_;
    std::optional<Time> stoppedAt_;
    Time begunAt_{0};
};

Outcome scan(EmulatedScanner& emulated, NoddingSource& source, Impatience& impatience, Time watchFrom)
{
    Outcome outcome;
    bool isBegun = false;
    constexpr Time kGiveUp = 60s;
    const Time until = emulated.clock().now() + kGiveUp;
    while (emulated.clock().now() < until && outcome.errors.size() < 40) {
        const Time before = emulated.clock().now();
        Result<std::optional<ScanSlice>> slice = std::nullopt;
        const std::stop_token stop = impatience.begin();
        if (isBegun) {
            slice = source.next(stop);
        } else if (const Result<void> begun = source.begin(stop); !begun) {
            slice = tl::unexpected{begun.error()};
        } else {
            isBegun = !impatience.hasStopped();
        }
        const Time now = emulated.clock().now();
        outcome.longestToStop = std::max(outcome.longestToStop, impatience.sinceStop());
        if (before >= watchFrom)
            outcome.longest = std::max(outcome.longest, now - before);
        if (!slice) {
            outcome.errors.push_back(slice.error());
            emulated.clock().advance(400ms);
            if (slice.error().code == ErrorCode::NeedsOperator)
                source.release();
        } else if (*slice) {
            outcome.slices.push_back(**slice);
            if (!outcome.resumed && now >= watchFrom)
                outcome.resumed = now;
        } else if (isBegun && !impatience.hasStopped() && outcome.wasAsked) {
            outcome.isComplete = true;
            break;
        }
        outcome.wasAsked = isBegun;
    }
    return outcome;
}

/// Ranges tell where the head was: floor and ceiling move with it.
bool isMeasured(const ScanSlice& slice)
{
    AcquisitionSettings settings;
    settings.slices = 1;
    settings.firstTilt = slice.tilt;
    settings.continuous = slice.tiltEnd.has_value();
    settings.tiltStep = slice.tiltEnd.value_or(slice.tilt) - slice.tilt;
    settings.firstBearing = slice.firstBearing;
    settings.beams = static_cast<int>(slice.ranges.size());
    const ScanSlice simulated = simulateSlice(room(), settings, {}, 1, 0).slice;
    int near = 0;
    for (std::size_t beam = 0; beam < slice.ranges.size(); ++beam)
        near += std::abs(slice.ranges[beam] - simulated.ranges[beam]) < 0.02 + 0.03 * simulated.ranges[beam];
    return near > 0.8 * static_cast<double>(slice.ranges.size());
}

/// Steps rise, and every slice that is not marked shows what is there.
void verifySlices(const Outcome& outcome, bool mayLie)
{
    int last = -1;
    for (const ScanSlice& slice : outcome.slices) {
        QVERIFY(slice.step > last && slice.step < kSlices);
        last = slice.step;
        QCOMPARE(slice.ranges.size(), std::size_t(241));
        QVERIFY2(mayLie || slice.angleSuspect || isMeasured(slice),
                 qPrintable(QString("slice %1 at %2 to %3, time %4")
                                .arg(slice.step)
                                .arg(toDegrees(slice.tilt))
                                .arg(toDegrees(slice.tiltEnd.value_or(0.0)))
                                .arg(slice.time.count())));
    }
}

/// The error that a fault of a device comes to first.
struct Ending {
    ErrorCode code;
    const char* says;    ///< words of the message, with | between them
    bool heals = false;  ///< by itself, or with the next attempt of the one who sits there
};

/// Empty for faults that cost slices at most.
std::optional<Ending> endingOf(const QString& kind, Mode mode)
{
    constexpr auto kLost = ErrorCode::DeviceLost;
    constexpr auto kPerson = ErrorCode::NeedsOperator;
    constexpr auto kOurs = ErrorCode::Internal;
    static const std::map<QString, Ending> endings{
        {"laser-malfunction", {kPerson, "the laser is faulty|a fault of its hardware"}},
        {"laser-unplug", {kLost, "laser: the device is gone"}},
        {"servo-stall", {kPerson, "servo 1 is stuck|stands at|load 100 %"}},
        {"servo-frozen", {kPerson, "servo 1 is stuck|stands at|load 6 %"}},
        {"servo-overload", {kPerson, "alarm (overload)"}},
        {"servo-overheat", {kPerson, "alarm (overheating)|82 °C (limit 80)"}},
        {"servo-voltage", {kPerson, "alarm (supply voltage out of range)|5.8 V"}},
        {"servo-silent", {kLost, "servo 1 does not answer"}},
        {"servo-garbled", {kLost, "answers come damaged"}},
        {"servo-wrong-id", {kLost, "number 7 answers in its place"}},
        {"servo-two", {kLost, "two servos"}},
        {"servo-echo", {kLost, "sends back what is sent to it"}},
        {"servo-power-loss", {kLost, "servo 1 does not answer"}},
        {"servo-slow", {kLost, "RX-64, number 1|no angle that can be used has come for|ms late|latency timer"}},
        {"servo-unplug", {kLost, "tilt unit: the device is gone"}},
        {"servo-wheel", {kPerson, "servo 1 is stuck"}},
        {"servo-wrong-angle", {kLost, "says that it has turned by|which it cannot"}},
        {"servo-angle-bit", {kOurs, "goal beyond the angle limits"}},
        {"servo-range-bit", {kOurs, "value out of range"}},
        {"servo-checksum-bit", {kOurs, "wrong checksum"}},
        {"servo-instruction-bit", {kOurs, "unknown instruction"}},
        {"board-silent", {kLost, "nothing comes from the control board any more"}},
        {"board-unplug", {kLost, "tilt unit: the device is gone"}},
        {"board-stall", {kPerson, "something holds it"}},
        {"board-wrong-angle", {kPerson, "the angle it measures is|slips"}},
        {"board-button", {kPerson, "stopped in an emergency"}},
        {"board-overload", {kPerson, "overloaded"}},
        {"board-overheat", {kPerson, "too hot"}},
        {"board-voltage", {kPerson, "voltage is out of its limits"}},
        {"board-reset", {kPerson, "has started anew", true}},
        {"board-watchdog", {kPerson, "no heartbeat reached it in time", true}}};
    // A servo that turns without end passes all angles of a sweep; one that rests may answer late.
    if (kind == (mode == Mode::Continuous ? "servo-wheel" : "servo-slow"))
        return std::nullopt;
    const auto ending = endings.find(kind);
    return ending == endings.end() ? std::nullopt : std::optional{ending->second};
}

}  // namespace

void NoddingFaultsTest::everyFaultOfADeviceEndsOrHeals_data()
{
    QTest::addColumn<QString>("kind");
    QTest::addColumn<Tilt>("tilt");
    QTest::addColumn<Mode>("mode");
    for (const EmulatedFaultKind& kind : emulatedFaultKinds()) {
        const QString name = QString::fromLatin1(kind.name.data(), static_cast<qsizetype>(kind.name.size()));
        const Tilt tilt = kind.name.starts_with("board-") ? Tilt::Board : Tilt::Servo;
        QTest::newRow(qPrintable(name + ", sweeping")) << name << tilt << Mode::Continuous;
        QTest::newRow(qPrintable(name + ", stepping")) << name << tilt << Mode::StepAndStare;
    }
}

void NoddingFaultsTest::everyFaultOfADeviceEndsOrHeals()
{
    QFETCH(QString, kind);
    QFETCH(Tilt, tilt);
    QFETCH(Mode, mode);
    EmulatedRigSetup setup;
    setup.scene = room();
    setup.tilt = tilt;
    setup.startPitch = degrees(60.0);
    setup.faults = {{kind.toStdString(), 15}};
    EmulatedScanner emulated(setup);
    Impatience impatience(emulated);
    const auto source = emulated.open(faultsPlan(mode));
    QVERIFY2(source.has_value(), source ? "" : source.error().message.c_str());

    const Outcome outcome = scan(emulated, **source, impatience, 0s);

    QVERIFY2(outcome.longestToStop <= kPatience, qPrintable(QString::number(outcome.longestToStop / 1ms)));

    // A position that is a lie is as good as a true one where it does not jump.
    verifySlices(outcome, kind.endsWith("wrong-angle") || kind == "laser-blind");
    const std::optional<Ending> ending = endingOf(kind, mode);
    QCOMPARE(outcome.errors.empty(), !ending.has_value());
    if (ending) {
        QCOMPARE(outcome.errors.front().code, ending->code);
        const QString message = QString::fromStdString(outcome.errors.front().message);
        for (const QString& words : QString(ending->says).split('|'))
            QVERIFY2(message.contains(words), qPrintable(message));
    }
    if (!ending || ending->heals) {
        QVERIFY2(outcome.isComplete, outcome.errors.empty() ? "" : outcome.errors.back().message.c_str());
        QVERIFY2(outcome.slices.size() > 30, qPrintable(QString::number(outcome.slices.size())));
    }
    if (!outcome.isComplete) {
        QVERIFY(!outcome.errors.empty());
        const double held = emulated.rig().pitchAt(emulated.clock().now());
        emulated.clock().advance(1s);
        QVERIFY(std::abs(emulated.rig().pitchAt(emulated.clock().now()) - held) < degrees(0.5));
    }
}

void NoddingFaultsTest::wrongAnglesAreNoticed_data()
{
    QTest::addColumn<Tilt>("tilt");
    QTest::newRow("servo") << Tilt::Servo;
    QTest::newRow("board") << Tilt::Board;
}

/// For a second of a scan of some seconds all angles are 60 counts too high, which is 17.6 degrees.
void NoddingFaultsTest::wrongAnglesAreNoticed()
{
    QFETCH(Tilt, tilt);
    EmulatedRigSetup setup;
    setup.scene = room();
    setup.tilt = tilt;
    setup.startPitch = degrees(60.0);
    EmulatedScanner emulated(setup);
    LinkFault fault;
    fault.kind = LinkFault::Kind::WrongAngle;
    fault.counts = 60;
    fault.from = 2500ms;
    fault.to = 3500ms;
    const auto random = std::make_shared<Random>(1);
    emulated.wrapTilt = [&](std::unique_ptr<Transport> link) -> std::unique_ptr<Transport> {
        return std::make_unique<FaultyLink>(std::move(link), fault, random, emulated.clock());
    };
    Impatience impatience(emulated);
    const auto source = emulated.open(faultsPlan(Mode::StepAndStare));
    QVERIFY2(source.has_value(), source ? "" : source.error().message.c_str());

    const Outcome outcome = scan(emulated, **source, impatience, fault.to);

    QVERIFY(!outcome.errors.empty());
    QVERIFY(outcome.isComplete);
    for (const ScanSlice& slice : outcome.slices)
        QVERIFY(std::abs(slice.tilt - slice.tiltCommanded.value()) < degrees(1.0));
}

void NoddingFaultsTest::aFaultOfTheCableHeals_data()
{
    QTest::addColumn<int>("seed");
    const int seeds = (qEnvironmentVariableIsSet("PLANEWRIGHT_TEST_LONG") ? 500 : 50) / (kIsSanitized ? 10 : 1);
    for (int seed = 1; seed <= seeds; ++seed)
        QTest::newRow(qPrintable(QString::number(seed))) << seed;
}

void NoddingFaultsTest::aFaultOfTheCableHeals()
{
    QFETCH(int, seed);
    const auto random = std::make_shared<Random>(static_cast<std::uint64_t>(seed));
    EmulatedRigSetup setup;
    setup.scene = room();
    setup.tilt = random->integer(0, 1) == 0 ? Tilt::Servo : Tilt::Board;
    setup.startPitch = degrees(60.0);
    const Mode mode = random->integer(0, 1) == 0 ? Mode::Continuous : Mode::StepAndStare;
    LinkFault fault;
    fault.kind = static_cast<LinkFault::Kind>(random->integer(0, 5));
    fault.rate = std::pow(10.0, random->uniform(-6.0, -2.0));
    fault.delay = std::chrono::milliseconds(random->integer(0, 5000));
    fault.counts = static_cast<int>(random->integer(5, 200));
    const bool isOnLaser = random->integer(0, 1) == 0 && fault.kind != LinkFault::Kind::WrongAngle;
    EmulatedScanner emulated(setup);
    // The fault begins within the scan, which begins when both are connected.
    Time from{0};
    auto wrap = [&](std::unique_ptr<Transport> link) -> std::unique_ptr<Transport> {
        return std::make_unique<FaultyLink>(std::move(link), fault, random, emulated.clock());
    };
    from = emulated.clock().now() + std::chrono::milliseconds(random->integer(1500, 3500));
    fault.from = from;
    fault.to = from + std::chrono::milliseconds(random->integer(100, 4000));
    (isOnLaser ? emulated.wrapLaser : emulated.wrapTilt) = wrap;
    Impatience impatience(emulated);
    const auto source = emulated.open(faultsPlan(mode));
    QVERIFY2(source.has_value(), source ? "" : source.error().message.c_str());
    // What was delayed has come by then.
    const Time healed = fault.to + (fault.kind == LinkFault::Kind::Delay ? fault.delay : Time{0});

    const Outcome outcome = scan(emulated, **source, impatience, healed);

    const QString what = QString("kind %1, %2, %3, %4 to %5 ms, rate %6, delay %7 ms: ")
                             .arg(static_cast<int>(fault.kind))
                             .arg(isOnLaser                   ? "laser"
                                  : setup.tilt == Tilt::Servo ? "servo"
                                                              : "board")
                             .arg(mode == Mode::Continuous ? "sweeping" : "stepping")
                             .arg(fault.from / 1ms)
                             .arg(fault.to / 1ms)
                             .arg(fault.rate)
                             .arg(fault.delay / 1ms);
    // A position that is a lie is as good as a true one where it does not jump.
    verifySlices(outcome, fault.kind == LinkFault::Kind::WrongAngle);
    if (QTest::currentTestFailed())
        qWarning("%s", qPrintable(what));
    QVERIFY2(outcome.isComplete,
             qPrintable(what + (outcome.errors.empty() ? QString("no end")
                                                       : QString::fromStdString(outcome.errors.back().message))));
    QVERIFY2(outcome.longestToStop <= kPatience,
             qPrintable(what + QString("a stop took %1 ms").arg(outcome.longestToStop / 1ms)));
    QVERIFY2(outcome.longest <= kRecovery, qPrintable(what + QString("a call took %1 ms").arg(outcome.longest / 1ms)));
    if (outcome.resumed) {
        const Time after = *outcome.resumed - healed;
        QVERIFY2(after <= kRecovery, qPrintable(what + QString("the next slice came %1 ms later").arg(after / 1ms)));
    }
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::NoddingFaultsTest)
#include "nodding_faults_test.moc"
