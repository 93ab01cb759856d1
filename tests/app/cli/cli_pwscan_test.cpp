// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <fstream>

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>

#include "core/formats/parameter_events.h"
#include "core/formats/pwscan_writer.h"
#include "core/formats/recording_pwscan.h"
#include "run_program.h"
#include "tests/core/formats/pwscan_sample.h"
#include "tests/test_program.h"

using namespace planewright;

/// Every command takes a .pwscan where it takes CSV.
class CliPwscanTest : public QObject {
    Q_OBJECT

private slots:
    void csvComesBackByteForByte();
    void planesAreThoseOfTheCsv();
    void simulateWritesTheSameRecording();
    void scanOfACsvIsWrongUsage();
    void aScanOfSuspectSlicesAloneIsUnreadable();
    void damagedFileIsUsedInPart();
    void infoTellsEveryScan();
    void validateFindsEveryProblem();
    void aRecordingThatWasBrokenOffIsRead();
    void whatLiesBesideABrokenOffRecordingIsNotMixedWithAnother();

private:
    static void write(const QTemporaryDir& folder, const Recording& recording,
                      const std::optional<ScanNotes>& notes = std::nullopt);
};

void CliPwscanTest::write(const QTemporaryDir& folder, const Recording& recording,
                          const std::optional<ScanNotes>& notes)
{
    std::ofstream out(folder.filePath("a.pwscan").toStdString(), std::ios::binary);
    QVERIFY(writeRecordingPwscan(out, recording, notes));
}

void CliPwscanTest::csvComesBackByteForByte()
{
    const QTemporaryDir folder;
    QByteArray text = "# serial = H123\n# place = cellar, 2nd \"floor\"\n" + recordingText(3, 4, 1500);
    text.replace("pitch_deg,", "pitch_deg,pitch_end_deg,bearing_start_deg,");
    for (int slice = 0; slice < 3; ++slice) {
        const QByteArray pitch = QByteArray::number(60 + slice);
        text.replace(pitch + ".00,", pitch + ".16," + pitch + ".7,0." + pitch + ",");
    }
    writeBytes(folder.filePath("foreign.csv"), text);
    runProgram({"convert", "foreign.csv", "a.csv"}, folder.path());

    const ProgramRun there = runProgram({"convert", "a.csv", "a.pwscan"}, folder.path());
    const ProgramRun back = runProgram({"convert", "a.pwscan", "b.csv"}, folder.path());
    const ProgramRun packed = runProgram({"convert", "a.pwscan", "b.csv.gz"}, folder.path());
    runProgram({"convert", "b.csv.gz", "c.csv"}, folder.path());

    QVERIFY2(there.code == 0, there.err);
    QVERIFY2(back.code == 0, back.err);
    QCOMPARE(packed.code, 0);
    QVERIFY(bytesOf(folder.filePath("a.csv")).contains("# place = cellar, 2nd \"floor\"\n"));
    QVERIFY(bytesOf(folder.filePath("a.csv")).contains(",60.16,60.7,0.6,"));
    QCOMPARE(bytesOf(folder.filePath("b.csv")), bytesOf(folder.filePath("a.csv")));
    QCOMPARE(bytesOf(folder.filePath("c.csv")), bytesOf(folder.filePath("a.csv")));
}

void CliPwscanTest::planesAreThoseOfTheCsv()
{
    const QTemporaryDir folder;
    QCOMPARE(simulateTwelve(folder.path()).code, 0);
    QCOMPARE(runProgram({"convert", "scan.csv", "scan.pwscan"}, folder.path()).code, 0);

    for (const char* kind : {"csv", "pwscan"})
        QCOMPARE(
            runProgram({"extract", QString("scan.") + kind, "--planes", QString(kind) + ".csv"}, folder.path()).code,
            0);

    QVERIFY(bytesOf(folder.filePath("csv.csv")).count('\n') > 10);
    QCOMPARE(bytesOf(folder.filePath("pwscan.csv")), bytesOf(folder.filePath("csv.csv")));
}

void CliPwscanTest::simulateWritesTheSameRecording()
{
    const QTemporaryDir folder;
    for (const char* name : {"a.csv", "a.pwscan"})
        QCOMPARE(runProgram({"simulate", "twelve", "-o", name, "--slices", "5"}, folder.path()).code, 0);

    QCOMPARE(runProgram({"convert", "a.pwscan", "b.csv"}, folder.path()).code, 0);

    QCOMPARE(bytesOf(folder.filePath("b.csv")), bytesOf(folder.filePath("a.csv")));
}

void CliPwscanTest::scanOfACsvIsWrongUsage()
{
    const QTemporaryDir folder;
    writeBytes(folder.filePath("a.csv"), recordingText(3, 4, 1500));

    const ProgramRun run = runProgram({"extract", "a.csv", "--scan", "1"}, folder.path());

    QCOMPARE(run.code, 2);
    QVERIFY(run.err.contains("a .csv holds one scan"));
}

void CliPwscanTest::aScanOfSuspectSlicesAloneIsUnreadable()
{
    const QTemporaryDir folder;
    Recording wrong = sampleRecording(2, 4);
    wrong.slices[0].angleSuspect = wrong.slices[1].angleSuspect = true;
    write(folder, wrong);

    const ProgramRun run = runProgram({"extract", "a.pwscan"}, folder.path());

    QCOMPARE(run.code, 3);
    QVERIFY(run.err.contains("a.pwscan: the angle of every slice is suspect; check the tilt unit and scan again"));
}

void CliPwscanTest::damagedFileIsUsedInPart()
{
    const QTemporaryDir folder;
    write(folder, sampleRecording(3, 4));
    runSql(folder.filePath("a.pwscan").toStdString(), "UPDATE slice SET crc32 = 0 WHERE step = 1");

    const ProgramRun run = runProgram({"convert", "a.pwscan", "a.csv"}, folder.path());

    QCOMPARE(run.code, 4);
    QCOMPARE(run.err, QByteArray("planewright-cli: warning: a.pwscan: scan 1, step 1: crc32 is not the check sum of "
                                 "the ranges; the slice is not used\n"));
    QVERIFY(bytesOf(folder.filePath("a.csv")).contains("\n2,"));
    QVERIFY(!bytesOf(folder.filePath("a.csv")).contains("\n1,"));
}

void CliPwscanTest::infoTellsEveryScan()
{
    const QTemporaryDir folder;
    ScanNotes notes;
    notes.scan.state = ScanState::Complete;
    notes.events = {parametersEvent(0, {})};
    notes.scan.name = "hall";
    notes.edits = {{1, {Edit::Kind::Rename, {0}, "floor", true}, false},
                   {2, {Edit::Kind::Rename, {0}, "ground", true}, true}};
    write(folder, sampleRecording(3, 4), notes);
    {
        auto writer = PwscanWriter::append(folder.filePath("a.pwscan").toStdString(), sampleScanRecord(2, "stairs"));
        QVERIFY(writer->write(sampleRecording(1, 2).slices[0]));
    }

    const ProgramRun run = runProgram({"info", "a.pwscan", "--json"}, folder.path());
    const QJsonArray scans = QJsonDocument::fromJson(run.out).array();
    const ProgramRun text = runProgram({"info", "a.pwscan"}, folder.path());

    QVERIFY2(run.code == 0, run.err);
    QCOMPARE(scans.size(), 2);
    QCOMPARE(scans[0].toObject()["name"].toString(), "hall");
    QCOMPARE(scans[0].toObject()["state"].toString(), "complete");
    QCOMPARE(scans[0].toObject()["slices"].toInt(), 3);
    QCOMPARE(scans[0].toObject()["events"].toInt(), 1);
    QCOMPARE(scans[0].toObject()["edits"].toInt(), 1);
    QCOMPARE(scans[1].toObject()["scan"].toInt(), 2);
    QCOMPARE(scans[1].toObject()["state"].toString(), "running");
    QCOMPARE(scans[1].toObject()["beams"].toInt(), 2);
    QVERIFY(QString::fromUtf8(text.out).simplified().contains("planned slices not given"));
}

void CliPwscanTest::validateFindsEveryProblem()
{
    const QTemporaryDir folder;
    write(folder, sampleRecording(3, 4));
    QCOMPARE(runProgram({"validate", "a.pwscan"}, folder.path()).out, QByteArray("a.pwscan: valid\n"));
    runSql(folder.filePath("a.pwscan").toStdString(),
           "UPDATE slice SET crc32 = 0 WHERE step = 1; UPDATE slice SET ranges = x'' WHERE step = 2");

    const ProgramRun run = runProgram({"validate", "a.pwscan"}, folder.path());
    writeBytes(folder.filePath("b.pwscan"), "x");

    QCOMPARE(run.code, 4);
    QCOMPARE(run.out, QByteArray("warning: a.pwscan: scan 1, step 1: crc32 is not the check sum of the ranges; the "
                                 "slice is not used\nwarning: a.pwscan: scan 1, step 2: ranges has 0 bytes instead of "
                                 "16; the slice is not used\na.pwscan: damaged\n"));
    QCOMPARE(runProgram({"validate", "b.pwscan"}, folder.path()).code, 3);
}

void CliPwscanTest::aRecordingThatWasBrokenOffIsRead()
{
    const QTemporaryDir folder;
    auto writer = PwscanWriter::create(folder.filePath("a.pwscan").toStdString(), sampleScanRecord(4));
    QVERIFY(writer->write(sampleRecording(1, 4).slices[0]));
    for (const char* name : {"", "-wal"})
        QVERIFY(QFile::copy(folder.filePath(QString("a.pwscan") + name), folder.filePath(QString("b.pwscan") + name)));

    const ProgramRun run = runProgram({"convert", "b.pwscan", "b.csv"}, folder.path());

    QVERIFY2(run.code == 0, run.err);
    QVERIFY(bytesOf(folder.filePath("b.csv")).contains("\n0,0.000000,10,1000,1001,1002,1003\n"));
}

void CliPwscanTest::whatLiesBesideABrokenOffRecordingIsNotMixedWithAnother()
{
    const QTemporaryDir folder;
    writeBytes(folder.filePath("a.csv"), recordingText(3, 4, 1500));
    writeBytes(folder.filePath("b.pwscan-wal"), "what a crash has left");

    const ProgramRun run = runProgram({"convert", "a.csv", "b.pwscan", "--overwrite"}, folder.path());

    QCOMPARE(run.code, 5);
    QVERIFY2(run.err.contains("b.pwscan: a recording of this name is being written, or was broken off and left "
                              "b.pwscan-wal; give another name"),
             run.err);
    QVERIFY(bytesOf(folder.filePath("b.pwscan")).isNull());
}

PLANEWRIGHT_TEST(CliPwscanTest)
#include "cli_pwscan_test.moc"
