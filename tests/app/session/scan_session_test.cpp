// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/session/scan_session.h"

#include <filesystem>
#include <fstream>

#include <QSignalSpy>
#include <QTemporaryDir>
#include <QtTest>

#include "core/formats/recording_csv.h"
#include "core/formats/recording_pwscan.h"
#include "tests/app/session/session_fixture.h"
#include "tests/test_program.h"

namespace planewright {

using namespace std::chrono_literals;

class ScanSessionTest : public QObject {
    Q_OBJECT

private slots:
    void aSimulatedScanGivesThePlanesOfABatch();
    void aRecordedScanOpensWithTheSamePlanesAndTakesEdits();
    void aCsvFileIsWorkedInAndReviewed();
    void aReplayIsPlayedAgain();
    void whatCannotBeOpenedLeavesWhatWasThere();
    void aPausedScanHoldsAndGoesOnStepByStep();
    void aScanThatIsFinishedEarlyKeepsItsSlices();
    void parametersChangedMidScanGiveThePlanesOfABatch();
    void aRerunTakesThePresentParameters();
    void aRerunOfAFileIsWhatTheFileGivesFromThenOn();
    void aCancelledRerunKeepsWhatWasThere();
    void aRerunIsTakenBackAndMadeAgain();
    void aRerunThatIsTakenBackLeavesTheParametersOfEachStep();
    void everyStepCanBeGoneBackTo();
    void aRecorderThatFailsForAWhileLosesNothing();
    void theStatusTellsHowTheScanGoesOn();
};

void ScanSessionTest::aSimulatedScanGivesThePlanesOfABatch()
{
    ScanSession session{smallOptions()};
    QSignalSpy states{&session, &ScanSession::stateChanged};
    QSignalSpy maps{&session, &ScanSession::mapChanged};
    OPEN_ROOM(session, "&speed=0");

    QVERIFY(session.start());
    WAIT_FOR(session, Review);

    QVERIFY(session.map()->finished);
    QCOMPARE(session.map()->step, 39);
    QCOMPARE(session.map()->plannedSteps, 40);
    QCOMPARE(session.map()->slices.size(), std::size_t(40));
    QCOMPARE(session.history().size(), std::size_t(41));
    QVERIFY(session.map()->snapshot->planes.size() >= 3);
    QCOMPARE(planesText(*session.map()->snapshot),
             batchPlanes(smallCorridor(), {{0, defaultParametersOfTheSimulation()}}));
    QVERIFY(maps.count() >= 1);
    std::vector<SessionState> seen;
    for (const auto& state : states)
        seen.push_back(state[0].value<SessionState>());
    QCOMPARE(seen, (std::vector{SessionState::Connecting, SessionState::Ready, SessionState::Homing,
                                SessionState::Scanning, SessionState::Finishing, SessionState::Review}));
}

void ScanSessionTest::aRecordedScanOpensWithTheSamePlanesAndTakesEdits()
{
    const QTemporaryDir folder;
    SessionOptions options = smallOptions();
    options.recordFolder = folder.path().toStdString();
    ScanSession session{options};
    OPEN_ROOM(session, "&speed=0");
    QVERIFY(session.start());
    WAIT_FOR(session, Review);
    const std::string planes = planesText(*session.map()->snapshot);
    const std::string path = session.status().recording;
    QVERIFY(session.status().recordedBytes > 0);
    QVERIFY(session.project() != nullptr);
    Edit edit;
    edit.kind = Edit::Kind::Rename;
    edit.planes = {0};
    edit.text = "floor";
    QVERIFY(session.project()->append(session.scanInProject(), edit));
    session.close();

    QVERIFY(session.open(path));
    WAIT_FOR(session, Review);

    QCOMPARE(planesText(*session.map()->snapshot), planes);
    QCOMPARE(session.storedEdits().size(), std::size_t(1));
    QCOMPARE(session.storedEdits()[0].edit.text, std::string("floor"));
    QVERIFY(session.project() != nullptr);
    const auto read = readRecordingPwscan(path);
    QVERIFY(read);
    QCOMPARE(read->notes.scan.state, ScanState::Complete);
}

void ScanSessionTest::aCsvFileIsWorkedInAndReviewed()
{
    const QTemporaryDir folder;
    const std::string path = folder.filePath("corridor.csv").toStdString();
    {
        std::ofstream file{path};
        QVERIFY(writeRecordingCsv(file, smallCorridor(), false));
    }
    ScanSession session{smallOptions()};

    QVERIFY(session.open(path));
    WAIT_FOR(session, Review);

    QCOMPARE(session.map()->slices.size(), std::size_t(40));
    QVERIFY(session.map()->finished);
    QCOMPARE(session.address(), path);
    QCOMPARE(session.status().source, std::string("corridor.csv"));
    QVERIFY(session.project() == nullptr);
}

void ScanSessionTest::aReplayIsPlayedAgain()
{
    const QTemporaryDir folder;
    const std::string path = folder.filePath("corridor.csv").toStdString();
    {
        std::ofstream file{path};
        QVERIFY(writeRecordingCsv(file, smallCorridor(), false));
    }
    FakeClock clock;
    ScanSession session{smallOptions(&clock)};
    QVERIFY(session.open("replay:" + path + "?speed=2"));
    WAIT_FOR(session, Review);
    const std::string planes = planesText(*session.map()->snapshot);

    QVERIFY(session.start());
    QCOMPARE(session.state(), SessionState::Replaying);
    WAIT_FOR(session, Review);

    QCOMPARE(planesText(*session.map()->snapshot), planes);
}

void ScanSessionTest::whatCannotBeOpenedLeavesWhatWasThere()
{
    ScanSession session{smallOptions()};
    QSignalSpy faults{&session, &ScanSession::faulted};

    QVERIFY(!session.open("sim:corridor?sped=1"));
    QCOMPARE(session.state(), SessionState::Empty);
    QVERIFY(session.open("sim:cathedral"));
    WAIT_FOR(session, Empty);
    QCOMPARE(faults.count(), 1);
    QVERIFY(faults[0][0].value<Error>().message.find("corridor, office") != std::string::npos);

    OPEN_ROOM(session, "&speed=0");
    QVERIFY(session.start());
    WAIT_FOR(session, Review);
    QVERIFY(session.open("/there/is/no/such.csv"));
    WAIT_FOR(session, Review);
    QCOMPARE(faults.count(), 2);
    QCOMPARE(session.map()->slices.size(), std::size_t(40));
}

void ScanSessionTest::aPausedScanHoldsAndGoesOnStepByStep()
{
    FakeClock clock{FakeClock::Kind::Stands};
    ScanSession session{smallOptions(&clock)};
    OPEN_ROOM(session, "");
    QVERIFY(session.start());
    QTRY_COMPARE(session.status().extracted, 1);

    QVERIFY(session.pauseOrContinue());
    QCOMPARE(session.state(), SessionState::Paused);
    clock.advance(1h);
    QVERIFY(session.step());
    QTRY_COMPARE(session.status().extracted, 2);
    QVERIFY(session.step());
    QTRY_COMPARE(session.status().extracted, 3);
    QTest::qWait(20);
    QCOMPARE(session.status().extracted, 3);
    QVERIFY(session.pauseOrContinue());
    QCOMPARE(session.state(), SessionState::Scanning);
    clock.advance(1h);

    WAIT_FOR(session, Review);
    QCOMPARE(session.map()->slices.size(), std::size_t(40));
}

void ScanSessionTest::aScanThatIsFinishedEarlyKeepsItsSlices()
{
    const QTemporaryDir folder;
    FakeClock clock{FakeClock::Kind::Stands};
    SessionOptions options = smallOptions(&clock);
    options.recordFolder = folder.path().toStdString();
    ScanSession session{options};
    OPEN_ROOM(session, "");
    QVERIFY(session.start());
    QTRY_COMPARE(session.status().acquired, 1);
    clock.advance(10 * 25ms);
    QTRY_COMPARE(session.status().extracted, 11);

    QVERIFY(session.finish());
    WAIT_FOR(session, Review);

    QCOMPARE(session.map()->slices.size(), std::size_t(11));
    QVERIFY(session.map()->finished);
    const auto read = readRecordingPwscan(session.status().recording);
    QVERIFY(read);
    QCOMPARE(read->read.recording.slices.size(), std::size_t(11));
    QCOMPARE(read->notes.scan.state, ScanState::Partial);
}

void ScanSessionTest::parametersChangedMidScanGiveThePlanesOfABatch()
{
    FakeClock clock{FakeClock::Kind::Stands};
    ScanSession session{smallOptions(&clock)};
    OPEN_ROOM(session, "");
    const Parameters before = session.parameters();
    Parameters changed = before;
    changed.likelihood.enoughPoints = 400;
    changed.planes.minPoints = 200;
    QVERIFY(session.start());
    QTRY_COMPARE(session.status().acquired, 1);
    clock.advance(16 * 25ms);
    QTRY_COMPARE(session.status().acquired, 17);

    QVERIFY(session.setParameters(changed));
    clock.advance(1h);
    WAIT_FOR(session, Review);

    QCOMPARE(planesText(*session.map()->snapshot), batchPlanes(smallCorridor(), {{0, before}, {17, changed}}));
    QCOMPARE(session.parameters().planes.minPoints, 200);
}

void ScanSessionTest::aRerunTakesThePresentParameters()
{
    ScanSession session{smallOptions()};
    OPEN_ROOM(session, "&speed=0");
    QVERIFY(session.start());
    WAIT_FOR(session, Review);
    Parameters changed = session.parameters();
    changed.likelihood.enoughPoints = 400;
    changed.sensor.pitchZero = degrees(1.0);

    QVERIFY(session.setParameters(changed));
    QVERIFY(session.rerun());
    QCOMPARE(session.state(), SessionState::Replaying);
    WAIT_FOR(session, Review);

    QCOMPARE(planesText(*session.map()->snapshot), batchPlanes(smallCorridor(), {{0, changed}}));
    QCOMPARE(session.map()->slices[0]->tilt, degrees(10.0) + degrees(1.0));
}

void ScanSessionTest::aRerunOfAFileIsWhatTheFileGivesFromThenOn()
{
    const QTemporaryDir folder;
    SessionOptions options = smallOptions();
    options.recordFolder = folder.path().toStdString();
    ScanSession session{options};
    OPEN_ROOM(session, "&speed=0");
    QVERIFY(session.start());
    WAIT_FOR(session, Review);
    Parameters changed = session.parameters();
    changed.likelihood.enoughPoints = 400;

    QVERIFY(session.setParameters(changed));
    QVERIFY(session.rerun());
    WAIT_FOR(session, Review);
    const std::string planes = planesText(*session.map()->snapshot);
    const std::string path = session.status().recording;
    session.close();

    const auto read = readRecordingPwscan(path);
    QVERIFY(read);
    const auto stored = readParameterEvents(read->notes.events, path);
    QVERIFY(stored);
    QCOMPARE(batchPlanes(read->read.recording, *stored), planes);
    QVERIFY(session.open(path));
    WAIT_FOR(session, Review);
    QCOMPARE(planesText(*session.map()->snapshot), planes);
}

void ScanSessionTest::aCancelledRerunKeepsWhatWasThere()
{
    ScanSession session{smallOptions()};
    OPEN_ROOM(session, "&speed=0");
    QVERIFY(session.start());
    WAIT_FOR(session, Review);
    const auto snapshot = session.map()->snapshot;

    QVERIFY(session.rerun());
    QVERIFY(session.cancel());
    WAIT_FOR(session, Review);

    QCOMPARE(session.map()->snapshot, snapshot);
}

void ScanSessionTest::everyStepCanBeGoneBackTo()
{
    ScanSession session{smallOptions()};
    OPEN_ROOM(session, "&speed=0");
    QVERIFY(session.start());
    WAIT_FOR(session, Review);

    QVERIFY(session.goToStep(7));

    QCOMPARE(session.map()->step, 7);
    QCOMPARE(session.map()->slices.size(), std::size_t(8));
    QCOMPARE(session.map()->snapshot->report.step, 7);
    QVERIFY(!session.map()->finished);
    QVERIFY(!session.map()->isNewest);
    QCOMPARE(session.mapAt(-5)->snapshot, nullptr);
    QVERIFY(session.mapAt(39)->finished);
    QVERIFY(session.goToPlace(39));
    QCOMPARE(session.map()->snapshot->report.step, 39);
    QVERIFY(!session.map()->finished);
    QVERIFY(session.goToPlace(40));
    QVERIFY(session.map()->finished);
    QVERIFY(session.goToNewest());
    QVERIFY(session.map()->isNewest);
}

void ScanSessionTest::aRecorderThatFailsForAWhileLosesNothing()
{
    auto recorded = std::make_shared<RecordedScan>();
    recorded->fails = true;
    FakeClock clock;
    SessionOptions options = smallOptions(&clock);
    options.recordFolder = "/nowhere";
    options.makeRecorder = [&](const std::string& /*path*/) { return std::make_unique<FakeRecorder>(recorded); };
    ScanSession session{options};
    QSignalSpy faults{&session, &ScanSession::faulted};
    QSignalSpy states{&session, &ScanSession::stateChanged};
    // As soon as somebody has heard of it, the disk is back.
    connect(&session, &ScanSession::faulted, &session, [&] { recorded->fails = false; });
    OPEN_ROOM(session, "");
    QVERIFY(session.start());
    WAIT_FOR(session, Review);

    QVERIFY(faults.count() >= 1);
    QVERIFY(faults[0][0].value<Error>().message.find("kept in memory") != std::string::npos);
    QCOMPARE(session.map()->slices.size(), std::size_t(40));
    QVERIFY(session.map()->finished);
}

void ScanSessionTest::theStatusTellsHowTheScanGoesOn()
{
    FakeClock clock;
    ScanSession session{smallOptions(&clock)};
    QSignalSpy statuses{&session, &ScanSession::statusChanged};
    QCOMPARE(session.status().source, std::string());
    OPEN_ROOM(session, "");

    QVERIFY(session.start());
    WAIT_FOR(session, Review);

    QVERIFY(statuses.count() >= 3);
    const SessionStatus status = session.status();
    QCOMPARE(status.source, std::string("Simulated corridor"));
    QCOMPARE(status.acquired, 40);
    QCOMPARE(status.extracted, 40);
    QCOMPARE(status.plannedSteps, 40);
    QCOMPARE(status.lost, 0);
    QCOMPARE(status.queueDepth, std::size_t(0));
}

void ScanSessionTest::aRerunIsTakenBackAndMadeAgain()
{
    const QTemporaryDir folder;
    SessionOptions options = smallOptions();
    options.recordFolder = folder.path().toStdString();
    ScanSession session{options};
    OPEN_ROOM(session, "&speed=0");
    QVERIFY(session.start());
    WAIT_FOR(session, Review);
    QSignalSpy made(&session, &ScanSession::rerunMade);
    const auto before = session.map()->snapshot;
    const int enough = session.parameters().likelihood.enoughPoints;
    Parameters changed = session.parameters();
    changed.likelihood.enoughPoints = enough + 200;
    QVERIFY(session.setParameters(changed));
    QVERIFY(session.rerun());
    QVERIFY(isRefusal(session.undoRerun()));
    WAIT_FOR(session, Review);
    const auto after = session.map()->snapshot;
    QVERIFY(after != before);
    QCOMPARE(made.count(), 1);
    QCOMPARE(session.rerunsToUndo(), std::size_t(1));

    QVERIFY(session.undoRerun());
    QCOMPARE(session.map()->snapshot, before);
    QCOMPARE(session.parameters().likelihood.enoughPoints, enough);
    QCOMPARE(session.rerunsToUndo(), std::size_t(0));
    QVERIFY(session.undoRerun());  // there is none
    QCOMPARE(session.map()->snapshot, before);

    QVERIFY(session.redoRerun());
    QCOMPARE(session.map()->snapshot, after);
    QCOMPARE(session.parameters().likelihood.enoughPoints, enough + 200);

    // The file gives what is shown.
    QVERIFY(session.undoRerun());
    const std::string planes = planesText(*before);
    const std::string path = session.status().recording;
    session.close();
    QCOMPARE(session.rerunsToUndo(), std::size_t(0));
    QVERIFY(session.open(path));
    WAIT_FOR(session, Review);
    QCOMPARE(planesText(*session.map()->snapshot), planes);
}

void ScanSessionTest::aRerunThatIsTakenBackLeavesTheParametersOfEachStep()
{
    const QTemporaryDir folder;
    SessionOptions options = smallOptions();
    options.recordFolder = folder.path().toStdString();
    ScanSession session{options};
    OPEN_ROOM(session, "&speed=0");
    QVERIFY(session.start());
    WAIT_FOR(session, Review);
    Parameters changed = session.parameters();
    const std::string path = session.status().recording;
    session.close();
    // It is said that it was extracted with others from step 17 on.
    const Parameters first = changed;
    changed.likelihood.enoughPoints += 200;
    {
        auto project = PwscanProject::open(path);
        QVERIFY(project);
        QVERIFY(project->appendParameters(1, changed, 17));
    }
    QVERIFY(session.open(path));
    WAIT_FOR(session, Review);
    const std::string planes = planesText(*session.map()->snapshot);
    QCOMPARE(planes, batchPlanes(smallCorridor(), {{0, first}, {17, changed}}));
    QVERIFY(session.rerun());
    WAIT_FOR(session, Review);

    QVERIFY(session.undoRerun());
    session.close();
    QVERIFY(session.open(path));
    WAIT_FOR(session, Review);

    QCOMPARE(planesText(*session.map()->snapshot), planes);
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::ScanSessionTest)
#include "scan_session_test.moc"
