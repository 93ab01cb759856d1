// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <filesystem>
#include <random>

#include <QTemporaryDir>
#include <QtTest>

#include "app/session/scan_session.h"
#include "tests/app/session/session_fixture.h"
#include "tests/test_program.h"

namespace planewright {

using namespace std::chrono_literals;

class ScanSessionStatesTest : public QObject {
    Q_OBJECT

private slots:
    void whatIsAskedAtTheWrongTimeIsAnsweredWithAReason();
    void stopMotionEndsAScanInEveryState();
    void aStopOfMotionStaysUntilItIsReleased();
    void aSessionEndsInEveryState();
    void aHundredScansLeaveNoThread();
    void randomVerbsLeaveNoRecordingOpen_data();
    void randomVerbsLeaveNoRecordingOpen();
};

namespace {

std::ptrdiff_t threads()
{
    const std::filesystem::directory_iterator tasks{"/proc/self/task"};
    return std::distance(begin(tasks), end(tasks));
}

/// A session that records nowhere, and its clock.
struct FakeSession {
    FakeSession()
    {
        SessionOptions options = smallOptions(&clock);
        options.recordFolder = "/nowhere";
        options.makeRecorder = [this](const std::string& /*path*/) {
            recordings.push_back(std::make_shared<RecordedScan>());
            return std::make_unique<FakeRecorder>(recordings.back());
        };
        session = std::make_unique<ScanSession>(options);
    }

    FakeClock clock{FakeClock::Kind::Stands};
    std::vector<std::shared_ptr<RecordedScan>> recordings;
    std::unique_ptr<ScanSession> session;
};

}  // namespace

void ScanSessionStatesTest::whatIsAskedAtTheWrongTimeIsAnsweredWithAReason()
{
    FakeSession fake;
    ScanSession& session = *fake.session;

    QVERIFY(isRefusal(session.start()));
    QVERIFY(isRefusal(session.pauseOrContinue()));
    QVERIFY(isRefusal(session.step()));
    QVERIFY(isRefusal(session.finish()));
    QVERIFY(isRefusal(session.retry()));
    QVERIFY(isRefusal(session.rerun()));
    QVERIFY(isRefusal(session.cancel()));
    QVERIFY(isRefusal(session.goToStep(3)));
    QVERIFY(isRefusal(session.setSpeed(2.0)));
    QVERIFY(!session.refusal(SessionRequest::Start).isEmpty());
    QVERIFY(session.refusal(SessionRequest::Open).isEmpty());
    OPEN_ROOM(session, "");
    QVERIFY(session.start());
    WAIT_FOR(session, Scanning);
    QVERIFY(isRefusal(session.open("sim:office")));
    QVERIFY(isRefusal(session.start()));
    QVERIFY(isRefusal(session.step()));
    QVERIFY(isRefusal(session.rerun()));
}

void ScanSessionStatesTest::stopMotionEndsAScanInEveryState()
{
    FakeSession fake;
    ScanSession& session = *fake.session;
    QVERIFY(session.stopMotion());
    QCOMPARE(session.state(), SessionState::Empty);
    QVERIFY(session.isMotionStopped());
    QVERIFY(session.release());
    QVERIFY(session.open("sim:corridor?seed=3"));
    QVERIFY(session.stopMotion());
    QCOMPARE(session.state(), SessionState::Empty);
    OPEN_ROOM(session, "");
    QVERIFY(session.stopMotion());
    QCOMPARE(session.state(), SessionState::Ready);

    QVERIFY(session.release());
    QVERIFY(session.start());
    QVERIFY(session.stopMotion());
    QTRY_VERIFY(session.state() == SessionState::Ready || session.state() == SessionState::Review);
    QVERIFY(session.release());
    QVERIFY(session.start());
    QTRY_COMPARE(session.status().extracted, 1);
    QVERIFY(session.stopMotion());
    QCOMPARE(session.state(), SessionState::Finishing);
    QVERIFY(session.stopMotion());
    WAIT_FOR(session, Review);
    QVERIFY(session.release());
    QVERIFY(session.start());
    WAIT_FOR(session, Scanning);
    QVERIFY(session.pauseOrContinue());
    QVERIFY(session.stopMotion());
    QTRY_VERIFY(session.state() == SessionState::Ready || session.state() == SessionState::Review);
    QVERIFY(session.stopMotion());

    for (const auto& recording : fake.recordings)
        QVERIFY(!recording->isOpen);
}

void ScanSessionStatesTest::aStopOfMotionStaysUntilItIsReleased()
{
    FakeSession fake;
    ScanSession& session = *fake.session;
    OPEN_ROOM(session, "");
    QSignalSpy told(&session, &ScanSession::motionStoppedChanged);

    QVERIFY(session.stopMotion());

    QVERIFY(session.isMotionStopped());
    QCOMPARE(told.size(), 1);
    const auto started = session.start();
    QVERIFY(isRefusal(started));
    QVERIFY(QString::fromStdString(started.error().message).contains("Release"));
    QCOMPARE(session.state(), SessionState::Ready);
    QVERIFY(session.release());
    QVERIFY(!session.isMotionStopped());
    QCOMPARE(told.size(), 2);
    QVERIFY(isRefusal(session.release()));
    QVERIFY(session.start());
}

void ScanSessionStatesTest::aSessionEndsInEveryState()
{
    const auto end = [](int how) {
        FakeSession fake;
        ScanSession& session = *fake.session;
        if (how >= 1)
            QVERIFY(session.open("sim:corridor?seed=3"));
        if (how >= 2)
            WAIT_FOR(session, Ready);
        if (how >= 3)
            QVERIFY(session.start());
        if (how >= 4)
            WAIT_FOR(session, Scanning);
        if (how == 5)
            QVERIFY(session.pauseOrContinue());
        if (how >= 6)
            QVERIFY(session.finish());
        if (how >= 7)
            QTRY_VERIFY(session.state() == SessionState::Review || session.state() == SessionState::Ready);
        const auto before = steadyClock().now();
        fake.session.reset();
        QVERIFY(steadyClock().now() - before < 20s);
        for (const auto& recording : fake.recordings)
            QVERIFY(!recording->isOpen);
    };
    for (int how = 0; how <= 7; ++how)
        end(how);
}

void ScanSessionStatesTest::aHundredScansLeaveNoThread()
{
    FakeSession fake;
    ScanSession& session = *fake.session;
    OPEN_ROOM(session, "&speed=0");
    QVERIFY(session.start());
    WAIT_FOR(session, Review);
    const std::ptrdiff_t before = threads();

    for (int cycle = 0; cycle < 100; ++cycle) {
        QVERIFY(session.start());
        if (cycle % 2 == 0) {
            QVERIFY(session.stopMotion());
            QVERIFY(session.release());
        }
        QTRY_VERIFY(session.state() == SessionState::Review || session.state() == SessionState::Ready);
    }

    QTRY_VERIFY(threads() <= before);
}

void ScanSessionStatesTest::randomVerbsLeaveNoRecordingOpen_data()
{
    QTest::addColumn<unsigned>("seed");
    for (unsigned seed = 1; seed <= 10; ++seed)
        QTest::addRow("seed %u", seed) << seed;
}

void ScanSessionStatesTest::randomVerbsLeaveNoRecordingOpen()
{
    QFETCH(unsigned, seed);
    std::mt19937 random{seed};
    FakeSession fake;
    ScanSession& session = *fake.session;
    for (int i = 0; i < 300; ++i) {
        Result<void> done;
        switch (random() % 14) {
            case 0:
                done = session.open("sim:corridor?seed=3");
                break;
            case 1:
                done = session.cancel();
                break;
            case 2:
            case 3:
                done = session.start();
                break;
            case 4:
                done = session.pauseOrContinue();
                break;
            case 5:
                done = session.step();
                break;
            case 6:
                done = session.finish();
                break;
            case 7:
                QVERIFY(session.stopMotion());
                break;
            case 8:
                done = session.setParameters(session.parameters());
                break;
            case 9:
                done = session.rerun();
                break;
            case 10:
                done = session.goToStep(static_cast<int>(random() % 40));
                break;
            case 11:
                if (random() % 8 == 0)
                    session.close();
                else
                    done = session.release();
                break;
            default:
                fake.clock.advance((random() % 20) * 25ms);
                QTest::qWait(static_cast<int>(random() % 5));
        }
        QVERIFY(done || isRefusal(done));
    }

    session.close();

    QCOMPARE(session.state(), SessionState::Empty);
    for (const auto& recording : fake.recordings)
        QVERIFY(!recording->isOpen);
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::ScanSessionStatesTest)
#include "scan_session_states_test.moc"
