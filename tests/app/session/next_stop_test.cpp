// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <filesystem>
#include <string>

#include <QTemporaryDir>
#include <QtTest>

#include "app/session/scan_session.h"
#include "core/formats/recording_pwscan.h"
#include "tests/app/session/session_fixture.h"
#include "tests/test_program.h"

namespace planewright {

class NextStopTest : public QObject {
    Q_OBJECT

private slots:
    void theNextStopIsOneScanMoreInTheSameFile();
    void anEditOfTheNextStopIsItsOwn();
    void withoutARecordedScanThereIsNoNextStop();
    void aRecordingHasNoNextStop();
    void aFileThatIsGoneHasNoNextStop();
    void theScanAfterTheNextStopHasAFileOfItsOwn();
};

// A macro, so that a failure names the line of the test.
#define RECORD_FIRST_STOP(session)    \
    OPEN_ROOM((session), "&speed=0"); \
    QVERIFY((session).start());       \
    WAIT_FOR((session), Review)

namespace {

SessionOptions recordedInto(const QTemporaryDir& folder)
{
    SessionOptions options = smallOptions();
    options.recordFolder = folder.path().toStdString();
    return options;
}

}  // namespace

void NextStopTest::theNextStopIsOneScanMoreInTheSameFile()
{
    const QTemporaryDir folder;
    ScanSession session{recordedInto(folder)};
    RECORD_FIRST_STOP(session);
    const std::string path = session.status().recording;
    QVERIFY(session.nextStopRefusal().isEmpty());

    QVERIFY(session.startNextStop());
    WAIT_FOR(session, Review);

    QCOMPARE(session.status().recording, path);
    QCOMPARE(session.map()->slices.size(), std::size_t(40));
    QCOMPARE(session.scanInProject(), 2);
    QVERIFY(session.project() != nullptr);
    const auto scans = session.project()->scans();
    QVERIFY(scans);
    QCOMPARE(scans->size(), std::size_t(2));
    session.close();
    for (const int scan : {1, 2}) {
        const auto read = readRecordingPwscan(path, scan);
        QVERIFY(read);
        QCOMPARE(read->notes.scan.state, ScanState::Complete);
        QCOMPARE(read->read.recording.slices.size(), std::size_t(40));
    }
}

void NextStopTest::anEditOfTheNextStopIsItsOwn()
{
    const QTemporaryDir folder;
    ScanSession session{recordedInto(folder)};
    RECORD_FIRST_STOP(session);
    QVERIFY(session.startNextStop());
    WAIT_FOR(session, Review);
    Edit edit;
    edit.kind = Edit::Kind::Rename;
    edit.planes = {0};
    edit.text = "floor";

    QVERIFY(session.project()->append(session.scanInProject(), edit));

    QCOMPARE(session.project()->edits(1)->size(), std::size_t(0));
    QCOMPARE(session.project()->edits(2)->size(), std::size_t(1));
}

void NextStopTest::withoutARecordedScanThereIsNoNextStop()
{
    ScanSession session{smallOptions()};
    OPEN_ROOM(session, "&speed=0");
    QVERIFY(session.nextStopRefusal().contains(QLatin1String("not recorded")));
    QVERIFY(session.start());
    WAIT_FOR(session, Review);

    const auto started = session.startNextStop();

    QVERIFY(!started);
    QCOMPARE(started.error().code, ErrorCode::Usage);
    QCOMPARE(session.state(), SessionState::Review);
}

void NextStopTest::aRecordingHasNoNextStop()
{
    const QTemporaryDir folder;
    ScanSession session{recordedInto(folder)};
    RECORD_FIRST_STOP(session);
    const std::string path = session.status().recording;
    session.close();
    QVERIFY(session.open(path));
    WAIT_FOR(session, Review);

    QVERIFY(!session.startNextStop());
    QVERIFY(session.nextStopRefusal().contains(QLatin1String("Connect a scanner")));
}

void NextStopTest::aFileThatIsGoneHasNoNextStop()
{
    const QTemporaryDir folder;
    ScanSession session{recordedInto(folder)};
    RECORD_FIRST_STOP(session);

    std::filesystem::remove(session.status().recording);

    QVERIFY(!session.startNextStop());
}

void NextStopTest::theScanAfterTheNextStopHasAFileOfItsOwn()
{
    const QTemporaryDir folder;
    ScanSession session{recordedInto(folder)};
    RECORD_FIRST_STOP(session);
    QVERIFY(session.startNextStop());
    WAIT_FOR(session, Review);
    const std::string path = session.status().recording;

    QVERIFY(session.start());
    WAIT_FOR(session, Review);

    QVERIFY(session.status().recording != path);
    QCOMPARE(session.scanInProject(), 1);
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::NextStopTest)
#include "next_stop_test.moc"
