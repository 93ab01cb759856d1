// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <QTemporaryDir>
#include <QtTest>

#include "core/simulation/scene.h"
#include "devices/board/board_speech.h"
#include "devices/dynamixel/servo_speech.h"
#include "devices/transport/dialogue_recorder.h"
#include "devices/transport/replayed_talk.h"
#include "tests/devices/nodding/emulated_scanner.h"
#include "tests/test_program.h"

namespace planewright {

using namespace std::chrono_literals;

/// A whole scan is recorded, every byte of both devices, and taken again from the record.
class ReplayedScanTest : public QObject {
    Q_OBJECT
    using Tilt = EmulatedRigSetup::Tilt;

private slots:
    void theSameSlicesComeAgain_data();
    void theSameSlicesComeAgain();
    void whoAsksAtOtherMomentsIsAnsweredToo_data();
    void whoAsksAtOtherMomentsIsAnsweredToo();

private:
    std::vector<ScanSlice> record(Tilt tilt);
    std::vector<ScanSlice> replay(Tilt tilt, std::chrono::nanoseconds from, std::chrono::nanoseconds pause);
    Result<std::unique_ptr<Transport>> openTalk(Tilt tilt, const Clock& clock) const;

    QTemporaryDir folder_;
    std::string laserFile_ = folder_.filePath("laser.dialogue").toStdString();
    std::string tiltFile_ = folder_.filePath("tilt.dialogue").toStdString();
};

namespace {

ScanPlan shortPlan()
{
    ScanPlan plan;
    plan.firstPitch = degrees(60.0);
    plan.slices = 30;
    return plan;
}

/// All slices; `pause` passes between two of them.
std::vector<ScanSlice> takeAllWithPause(NoddingSource& scanner, FakeClock& clock, std::chrono::nanoseconds pause)
{
    std::vector<ScanSlice> slices;
    for (;;) {
        const auto slice = scanner.next({});
        if (!slice)
            qWarning("%s", slice.error().message.c_str());
        if (!slice || !*slice)
            return slices;
        slices.push_back(**slice);
        clock.advance(pause);
    }
}

std::vector<ScanSlice> scan(NoddingDevices devices, FakeClock& clock, std::chrono::nanoseconds pause)
{
    auto scanner = NoddingSource::open(std::move(devices), shortPlan(), clock, {});
    if (scanner) {
        if (const auto begun = (*scanner)->begin({}); begun)
            return takeAllWithPause(**scanner, clock, pause);
        else
            scanner = tl::unexpected{begun.error()};
    }
    qWarning("%s", scanner.error().message.c_str());
    return {};
}

}  // namespace

std::vector<ScanSlice> ReplayedScanTest::record(Tilt tilt)
{
    EmulatedRigSetup setup;
    setup.scene = makeScene("corridor", 7).value();
    setup.tilt = tilt;
    EmulatedScanner emulated{setup};
    const auto recordTo = [&](const std::string& path) {
        return [&emulated, path](std::unique_ptr<Transport> link) -> std::unique_ptr<Transport> {
            std::remove(path.c_str());
            auto writer = DialogueWriter::create(path, link->name()).value();
            return std::make_unique<DialogueRecorder>(std::move(link), std::move(writer), emulated.clock());
        };
    };
    emulated.wrapLaser = recordTo(laserFile_);
    emulated.wrapTilt = recordTo(tiltFile_);
    return scan(emulated.devices(), emulated.clock(), 0ns);
}

Result<std::unique_ptr<Transport>> ReplayedScanTest::openTalk(Tilt tilt, const Clock& clock) const
{
    std::unique_ptr<DialogueSpeech> speech = std::make_unique<ServoSpeech>();
    if (tilt == Tilt::Board)
        speech = std::make_unique<BoardSpeech>();
    auto talk = ReplayedTalk::open(tiltFile_, ReplayedTalk::Pace::Recorded, std::move(speech), clock);
    if (!talk)
        return tl::unexpected{talk.error()};
    return std::unique_ptr<Transport>(std::move(*talk));
}

std::vector<ScanSlice> ReplayedScanTest::replay(Tilt tilt, std::chrono::nanoseconds from,
                                                std::chrono::nanoseconds pause)
{
    FakeClock clock;
    clock.advance(from);
    EmulatedRigSetup setup;
    setup.scene = makeScene("corridor", 7).value();
    const TiltMounting mounting = EmulatedScanner{setup}.mounting();
    NoddingDevices devices;
    devices.openLaser = [&](const std::stop_token& stop) -> Result<std::unique_ptr<Laser>> {
        auto link = ReplayedDialogue::open(laserFile_, ReplayedDialogue::Pace::Recorded, clock);
        if (!link)
            return tl::unexpected{link.error()};
        auto laser = std::make_unique<ScipLaser>(std::move(*link), clock);
        const auto done = laser->connect(stop);
        return done ? Result<std::unique_ptr<Laser>>{std::move(laser)} : tl::unexpected{done.error()};
    };
    devices.openTiltUnit = [&](const std::stop_token& stop) -> Result<std::unique_ptr<TiltUnit>> {
        auto link = openTalk(tilt, clock);
        if (!link)
            return tl::unexpected{link.error()};
        std::unique_ptr<TiltUnit> unit;
        if (tilt == Tilt::Board) {
            BoardTiltOptions options;
            options.mounting = mounting;
            unit = std::make_unique<BoardTilt>(std::move(*link), clock, options);
        } else {
            DynamixelOptions options;
            options.mounting = mounting;
            options.baud = setup.baud;
            unit = std::make_unique<DynamixelTilt>(std::move(*link), clock, options);
        }
        const auto done = unit->connect(stop);
        return done ? Result<std::unique_ptr<TiltUnit>>{std::move(unit)} : tl::unexpected{done.error()};
    };
    return scan(std::move(devices), clock, pause);
}

void ReplayedScanTest::theSameSlicesComeAgain_data()
{
    QTest::addColumn<Tilt>("tilt");
    QTest::addColumn<int>("hours");  // by the clock: numbers and times of the host are others then
    QTest::newRow("servo") << Tilt::Servo << 0;
    QTest::newRow("servo, later") << Tilt::Servo << 7;
    QTest::newRow("board") << Tilt::Board << 0;
    QTest::newRow("board, later") << Tilt::Board << 7;
}

void ReplayedScanTest::theSameSlicesComeAgain()
{
    QFETCH(Tilt, tilt);
    QFETCH(int, hours);
    const auto then = record(tilt);
    QCOMPARE(then.size(), std::size_t(30));

    const auto now = replay(tilt, std::chrono::hours{hours}, 0ns);

    QCOMPARE(now.size(), then.size());
    for (std::size_t i = 0; i < then.size(); ++i) {
        QCOMPARE(now[i].step, then[i].step);
        QVERIFY(now[i].time == then[i].time);
        QVERIFY(now[i].ranges == then[i].ranges);
        QVERIFY(now[i].tilt == then[i].tilt);
        QVERIFY(now[i].tiltEnd == then[i].tiltEnd);
        QVERIFY(now[i].tiltCommanded == then[i].tiltCommanded);
        QVERIFY(now[i].firstBearing == then[i].firstBearing);
        QCOMPARE(now[i].timeSuspect, then[i].timeSuspect);
    }
}

void ReplayedScanTest::whoAsksAtOtherMomentsIsAnsweredToo_data()
{
    QTest::addColumn<Tilt>("tilt");
    QTest::newRow("servo") << Tilt::Servo;
    QTest::newRow("board") << Tilt::Board;
}

/// A program that takes its time between two slices asks a servo less often, and its heartbeats go out later.
void ReplayedScanTest::whoAsksAtOtherMomentsIsAnsweredToo()
{
    QFETCH(Tilt, tilt);
    const auto then = record(tilt);
    QCOMPARE(then.size(), std::size_t(30));

    const auto now = replay(tilt, 1h, 7ms);

    QCOMPARE(now.size(), then.size());
    for (std::size_t i = 0; i < then.size(); ++i)
        QCOMPARE(now[i].step, then[i].step);
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::ReplayedScanTest)
#include "replayed_scan_test.moc"
