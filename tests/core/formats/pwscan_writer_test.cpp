// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/formats/pwscan_writer.h"

#include <csignal>
#include <filesystem>
#include <sys/resource.h>

#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include "core/formats/parameter_events.h"
#include "core/formats/recording_pwscan.h"
#include "pwscan_sample.h"
#include "tests/test_program.h"

using namespace planewright;

class PwscanWriterTest : public QObject {
    Q_OBJECT

private slots:
    void aClosedFileIsOneFile();
    void slicesAreThereForOthersWhileTheScanRuns();
    void withoutCloseTheScanIsRunningAndWhole();
    void anExistingFileIsNotReplaced();
    void appendAddsAScanAndKeepsTheOthers();
    void aScanWithoutSlicesLeavesNoFile();
    void aScanWithoutSlicesLeavesTheOthersAsTheyWere();
    void aFileThatGotAnotherScanMeanwhileStays();
    void aScanWithSlicesIsNotDiscarded();
    void appendToWhatIsNoRecordingIsAnError();
    void appendToANewerVersionIsAnError();
    void parametersAndEventsAreKept();
    void aStepThatDoesNotRiseIsAnError();
    void aSliceThatReachedTheDiskAfterAllIsNotAnError();
    void closesWholeWhileAnotherHasItOpen();
    void anotherProgramThatWritesIsWaitedForAndTold();
    void goesOnWhenTheFileMayGrowAgain();
    void goesOnWhenAFullDiskHasRoomAgain();
    void aFolderThatIsNotThereIsAnError();
    void aFileThatWasExchangedIsAnError();
};

namespace {

PwscanWriter created(const std::string& path, int beams = 4)
{
    auto writer = PwscanWriter::create(path, sampleScanRecord(beams, "first"));
    if (!writer)
        qFatal("%s", writer.error().message.c_str());
    return std::move(*writer);
}

}  // namespace

void PwscanWriterTest::aClosedFileIsOneFile()
{
    const QTemporaryDir folder;
    const std::string path = folder.filePath("a.pwscan").toStdString();
    PwscanWriter writer = created(path);

    for (const ScanSlice& slice : sampleRecording(20, 4).slices)
        QVERIFY(writer.write(slice));
    QVERIFY(writer.close(ScanState::Complete));

    QCOMPARE(QDir(folder.path()).entryList(QDir::Files), QStringList{"a.pwscan"});
    const auto read = readRecordingPwscan(path);
    QVERIFY(read);
    QCOMPARE(read->read.recording.slices.size(), std::size_t(20));
    QVERIFY(read->notes.scan.state == ScanState::Complete);
    QCOMPARE(read->notes.scan.startedUtc, std::string("2026-03-01T08:30:00Z"));
    QCOMPARE(QDir(folder.path()).entryList(QDir::Files), QStringList{"a.pwscan"});
}

void PwscanWriterTest::slicesAreThereForOthersWhileTheScanRuns()
{
    const QTemporaryDir folder;
    const std::string path = folder.filePath("a.pwscan").toStdString();
    PwscanWriter writer = created(path);
    const Recording recording = sampleRecording(3, 4);

    for (std::size_t i = 0; i < 3; ++i) {
        QVERIFY(writer.write(recording.slices[i]));
        const auto read = readRecordingPwscan(path);

        QVERIFY2(read, read ? "" : read.error().message.c_str());
        QCOMPARE(read->read.recording.slices.size(), i + 1);
        QVERIFY(read->notes.scan.state == ScanState::Running);
    }
    QCOMPARE(writer.slices(), 3);
}

void PwscanWriterTest::withoutCloseTheScanIsRunningAndWhole()
{
    const QTemporaryDir folder;
    const std::string path = folder.filePath("a.pwscan").toStdString();
    {
        PwscanWriter writer = created(path);
        QVERIFY(writer.write(sampleRecording(1, 4).slices[0]));
    }

    const auto read = readRecordingPwscan(path);

    QVERIFY(read);
    QVERIFY(read->notes.scan.state == ScanState::Running);
    QCOMPARE(pwscanProblems(path).problems.size(), std::size_t(0));
}

void PwscanWriterTest::anExistingFileIsNotReplaced()
{
    const QTemporaryDir folder;
    const std::string path = folder.filePath("a.pwscan").toStdString();
    QVERIFY(created(path).close(ScanState::Complete));

    const auto again = PwscanWriter::create(path, sampleScanRecord(4));

    QVERIFY(!again);
    QVERIFY(again.error().code == ErrorCode::NotWritten);
    QVERIFY(again.error().message.ends_with("a.pwscan: the file exists; add the scan to it, or give another name"));
}

void PwscanWriterTest::appendAddsAScanAndKeepsTheOthers()
{
    const QTemporaryDir folder;
    const std::string path = folder.filePath("a.pwscan").toStdString();
    PwscanWriter first = created(path);
    QVERIFY(first.write(sampleRecording(1, 4).slices[0]));
    QVERIFY(first.close(ScanState::Partial));

    auto second = PwscanWriter::append(path, sampleScanRecord(2, "second"));
    QVERIFY2(second, second ? "" : second.error().message.c_str());
    for (const ScanSlice& slice : sampleRecording(3, 2).slices)
        QVERIFY(second->write(slice));
    QVERIFY(second->close(ScanState::Complete));

    QCOMPARE(second->scan(), 2);
    QCOMPARE(readRecordingPwscan(path, 1)->read.recording.slices.size(), std::size_t(1));
    QVERIFY(readRecordingPwscan(path, 1)->notes.scan.state == ScanState::Partial);
    QCOMPARE(readRecordingPwscan(path)->read.recording.slices.size(), std::size_t(3));
    QCOMPARE(readRecordingPwscan(path)->notes.scan.name, std::string("second"));
}

void PwscanWriterTest::aScanWithoutSlicesLeavesNoFile()
{
    const QTemporaryDir folder;
    PwscanWriter writer = created(folder.filePath("a.pwscan").toStdString());
    QVERIFY(writer.write(ScanEvent{ScanEvent::Kind::Fault, {}, {}, "the cable is pulled out"}));

    QVERIFY(writer.discard());

    QVERIFY(QDir(folder.path()).isEmpty(QDir::Files | QDir::Hidden));
}

void PwscanWriterTest::aScanWithoutSlicesLeavesTheOthersAsTheyWere()
{
    const QTemporaryDir folder;
    const std::string path = folder.filePath("a.pwscan").toStdString();
    PwscanWriter first = created(path);
    QVERIFY(first.write(sampleRecording(1, 4).slices[0]));
    QVERIFY(first.write(ScanEvent{ScanEvent::Kind::Note, {}, {}, "mine"}));
    QVERIFY(first.close(ScanState::Complete));
    auto second = PwscanWriter::append(path, sampleScanRecord(2, "second"));
    QVERIFY(second);
    QVERIFY(second->write(ScanEvent{ScanEvent::Kind::Fault, {}, {}, "the cable is pulled out"}));

    QVERIFY(second->discard());

    QCOMPARE(QDir(folder.path()).entryList(QDir::Files), QStringList{"a.pwscan"});
    QCOMPARE(scansOfPwscan(path)->size(), std::size_t(1));
    const auto read = readRecordingPwscan(path);
    QCOMPARE(read->notes.scan.name, std::string("first"));
    QCOMPARE(read->notes.events.size(), std::size_t(1));
    QVERIFY(pwscanProblems(path).problems.empty());
}

void PwscanWriterTest::aFileThatGotAnotherScanMeanwhileStays()
{
    const QTemporaryDir folder;
    const std::string path = folder.filePath("a.pwscan").toStdString();
    PwscanWriter first = created(path);
    auto second = PwscanWriter::append(path, sampleScanRecord(4, "second"));
    QVERIFY(second);
    QVERIFY(second->write(sampleRecording(1, 4).slices[0]));

    QVERIFY(first.discard());

    QVERIFY(second->close(ScanState::Complete));
    QCOMPARE(scansOfPwscan(path)->size(), std::size_t(1));
    QCOMPARE(readRecordingPwscan(path)->notes.scan.name, std::string("second"));
}

void PwscanWriterTest::aScanWithSlicesIsNotDiscarded()
{
    const QTemporaryDir folder;
    const std::string path = folder.filePath("a.pwscan").toStdString();
    PwscanWriter writer = created(path);
    QVERIFY(writer.write(sampleRecording(1, 4).slices[0]));

    QVERIFY(writer.discard());

    const auto read = readRecordingPwscan(path);
    QCOMPARE(read->read.recording.slices.size(), std::size_t(1));
    QVERIFY(read->notes.scan.state == ScanState::Partial);
}

void PwscanWriterTest::appendToWhatIsNoRecordingIsAnError()
{
    const QTemporaryDir folder;
    const std::string other = folder.filePath("other.pwscan").toStdString();
    runSql(other, "CREATE TABLE scan(id INTEGER PRIMARY KEY)");

    const auto missing = PwscanWriter::append(folder.filePath("a.pwscan").toStdString(), sampleScanRecord(4));
    const auto foreign = PwscanWriter::append(other, sampleScanRecord(4));

    QVERIFY(!missing);
    QVERIFY(missing.error().message.ends_with("there is no such recording to add to; check its name"));
    QVERIFY(!foreign);
    QVERIFY(foreign.error().code == ErrorCode::Unreadable);
    QVERIFY(
        foreign.error().message.ends_with("this is a database, but no recording; give a file that was recorded as "
                                          ".pwscan"));
}

void PwscanWriterTest::appendToANewerVersionIsAnError()
{
    const QTemporaryDir folder;
    const std::string path = folder.filePath("a.pwscan").toStdString();
    QVERIFY(created(path).close(ScanState::Complete));
    runSql(path, "PRAGMA user_version = 2");

    const auto writer = PwscanWriter::append(path, sampleScanRecord(4));

    QVERIFY(!writer);
    QVERIFY(
        writer.error().message.ends_with("the recording is of a newer version; add to it with a newer version of "
                                         "the program"));
}

void PwscanWriterTest::parametersAndEventsAreKept()
{
    const QTemporaryDir folder;
    const std::string path = folder.filePath("a.pwscan").toStdString();
    PwscanWriter writer = created(path);
    Parameters parameters;
    QVERIFY(writer.writeParameters(0, parameters));
    QVERIFY(writer.write(sampleRecording(1, 4).slices[0]));
    parameters.planes.minSlices = 9;
    QVERIFY(writer.writeParameters(1, parameters));
    QVERIFY(writer.write(ScanEvent{ScanEvent::Kind::Pause, 1, std::chrono::microseconds{40}, "{}"}));
    QVERIFY(writer.close(ScanState::Fault));

    const auto read = readRecordingPwscan(path);
    const auto changed = readParameterEvents(read->notes.events, path);

    QVERIFY(changed);
    QCOMPARE(changed->size(), std::size_t(2));
    QCOMPARE(changed->at(0).step, 0);
    QCOMPARE(changed->at(1).step, 1);
    QCOMPARE(changed->at(1).parameters.planes.minSlices, 9);
    QVERIFY(read->notes.events[2].kind == ScanEvent::Kind::Pause);
    QVERIFY(read->notes.events[2].time == std::chrono::microseconds{40});
}

void PwscanWriterTest::aStepThatDoesNotRiseIsAnError()
{
    const QTemporaryDir folder;
    PwscanWriter writer = created(folder.filePath("a.pwscan").toStdString());
    ScanSlice slice = sampleRecording(1, 4).slices[0];
    slice.step = 5;
    QVERIFY(writer.write(slice));
    slice.step = 4;

    const auto written = writer.write(slice);

    QVERIFY(!written);
    QVERIFY(written.error().code == ErrorCode::Internal);
}

void PwscanWriterTest::aSliceThatReachedTheDiskAfterAllIsNotAnError()
{
    const QTemporaryDir folder;
    const std::string path = folder.filePath("a.pwscan").toStdString();
    PwscanWriter writer = created(path);
    const Recording recording = sampleRecording(2, 4);
    QVERIFY(writer.write(recording.slices[0]));
    // As if the answer to the commit of step 1 had been lost: the row of step 0 with its own time and another step.
    runSql(path, "INSERT INTO slice SELECT 1, 1, 25000, 11, NULL, NULL, NULL, 0, x'" +
                     QByteArray("e9030000ea030000eb030000ec030000").toStdString() + "', 268214650");

    const auto written = writer.write(recording.slices[1]);

    QVERIFY2(written, written ? "" : written.error().message.c_str());
    QCOMPARE(writer.slices(), 2);
}

void PwscanWriterTest::closesWholeWhileAnotherHasItOpen()
{
    const QTemporaryDir folder;
    const std::string path = folder.filePath("a.pwscan").toStdString();
    PwscanWriter writer = created(path);
    QVERIFY(writer.write(sampleRecording(1, 4).slices[0]));
    sqlite3* other = nullptr;
    sqlite3_open(path.c_str(), &other);
    sqlite3_exec(other, "BEGIN; SELECT * FROM slice", nullptr, nullptr, nullptr);

    const auto closed = writer.close(ScanState::Complete);
    const auto read = readRecordingPwscan(path);
    sqlite3_close(other);

    QVERIFY(closed);
    QVERIFY(read);
    QVERIFY(read->notes.scan.state == ScanState::Complete);
    QVERIFY(readRecordingPwscan(path));
}

void PwscanWriterTest::anotherProgramThatWritesIsWaitedForAndTold()
{
    const QTemporaryDir folder;
    const std::string path = folder.filePath("a.pwscan").toStdString();
    PwscanWriter writer = created(path);
    const Recording recording = sampleRecording(2, 4);
    QVERIFY(writer.write(recording.slices[0]));
    sqlite3* other = nullptr;
    sqlite3_open(path.c_str(), &other);
    sqlite3_exec(other, "BEGIN IMMEDIATE", nullptr, nullptr, nullptr);

    const auto refused = writer.write(recording.slices[1]);
    sqlite3_close(other);
    const auto again = writer.write(recording.slices[1]);

    QVERIFY(!refused);
    QVERIFY(refused.error().message.ends_with("another program holds the file; close it there, or try again"));
    QVERIFY(again);
}

/// A limit on file sizes makes every write beyond it fail, for root too, on any file system.
void PwscanWriterTest::goesOnWhenTheFileMayGrowAgain()
{
    const QTemporaryDir folder;
    const std::string path = folder.filePath("a.pwscan").toStdString();
    PwscanWriter writer = created(path, 721);
    const Recording recording = sampleRecording(60, 721);
    std::signal(SIGXFSZ, SIG_IGN);
    rlimit before{};
    getrlimit(RLIMIT_FSIZE, &before);
    const rlimit small{64 * 1024, before.rlim_max};

    setrlimit(RLIMIT_FSIZE, &small);
    std::size_t slice = 0;
    Result<void> written;
    // A connection that is made anew may find room in a -wal that it has emptied: full is what stays so.
    for (int failures = 0; failures < 5 && slice < recording.slices.size();) {
        written = writer.write(recording.slices[slice]);
        slice += written ? 1 : 0;
        failures = written ? 0 : failures + 1;
    }
    const auto event = writer.write(ScanEvent{ScanEvent::Kind::Fault, 1, std::nullopt, std::string(100'000, 'x')});
    setrlimit(RLIMIT_FSIZE, &before);
    const auto meanwhile = readRecordingPwscan(path);
    const std::size_t untilFull = slice;
    for (; slice < recording.slices.size(); ++slice)
        QVERIFY(writer.write(recording.slices[slice]));

    QVERIFY(!written);
    QVERIFY(written.error().code == ErrorCode::NotWritten);
    QVERIFY2(written.error().message.ends_with("check the disk and its free space"), written.error().message.c_str());
    QVERIFY(!event);
    QVERIFY(meanwhile);
    QVERIFY(!meanwhile->read.damaged);
    QCOMPARE(meanwhile->read.recording.slices.size(), untilFull);
    QVERIFY(writer.close(ScanState::Complete));
    const auto read = readRecordingPwscan(path);
    QVERIFY(!read->read.damaged);
    QCOMPARE(read->read.recording.slices.size(), std::size_t(60));
}

/// In a file system of its own, which the helper mounts where the system lets it.
void PwscanWriterTest::goesOnWhenAFullDiskHasRoomAgain()
{
    const QTemporaryDir folder;
    for (const char* size : {"256k", "1m", "8m"}) {
        QProcess process;
        process.start("unshare", {"-rm", "sh", "-c",
                                  QString("mount -t tmpfs -o size=%1 tmpfs '%2' || exit 77; exec '%3' fill '%2'")
                                      .arg(size, folder.path(), RECORD_SLICES)});
        if (!process.waitForStarted() || !process.waitForFinished() || process.exitCode() == 77 ||
            process.readAllStandardError().contains("unshare"))
            QSKIP("this system lets nobody mount a tmpfs; a limit on file sizes stands in for it above");

        const QByteArray told = process.readAllStandardOutput();
        QVERIFY2(process.exitCode() == 0, told + process.readAllStandardError());
        QVERIFY2(told.contains("full: ") && told.contains("the disk is full; free some space"), told);
        QVERIFY2(told.contains("all slices are there"), told);
    }
}

void PwscanWriterTest::aFolderThatIsNotThereIsAnError()
{
    const auto writer = PwscanWriter::create("/nowhere/a.pwscan", sampleScanRecord(4));

    QVERIFY(!writer);
    QCOMPARE(writer.error().message,
             std::string("/nowhere/a.pwscan: the file cannot be opened; check its name, its folder and their "
                         "permissions"));
}

void PwscanWriterTest::aFileThatWasExchangedIsAnError()
{
    const QTemporaryDir folder;
    const std::string path = folder.filePath("a.pwscan").toStdString();
    PwscanWriter writer = created(path);
    QVERIFY(writer.write(sampleRecording(1, 4).slices[0]));
    for (const auto& entry : std::filesystem::directory_iterator(folder.path().toStdString()))
        std::filesystem::remove(entry.path());
    PwscanWriter other = created(path);
    QVERIFY(other.close(ScanState::Complete));

    const ScanSlice next = sampleRecording(2, 4).slices[1];
    const auto first = writer.write(next);
    const auto second = writer.write(next);

    QVERIFY(!first);
    QVERIFY(!second);
    QVERIFY(second.error().code == ErrorCode::NotWritten);
}

PLANEWRIGHT_TEST(PwscanWriterTest)
#include "pwscan_writer_test.moc"
