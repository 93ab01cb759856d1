// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include "run_program.h"
#include "tests/test_program.h"

class CliExtractTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void writesEveryKindOfOutput();
    void withoutOutputsPrintsATable();
    void untilIsAsIfTheScanHadEndedThere();
    void untilBeforeTheFirstStepIsAnError();
    void noiseToldFarTooSmallIsWarnedOf();
    void historyHasALinePerStepAndTheLastPass();
    void statsCountWhatThePlanesHold();
    void unknownKindOfOutputIsWrongUsage_data();
    void unknownKindOfOutputIsWrongUsage();
    void existingOutputIsKeptWithoutOverwrite();
    void whatIsThereIsNotDoneAgain();
    void twoOutputsMayNotBeOneFile();
    void outputThatCannotBeWrittenLeavesNothing_data();
    void outputThatCannotBeWrittenLeavesNothing();
    void limitOnFileSizesLeavesNothing();
    void standardOutputMayBeAnOutput();
    void closedStandardStreamsAreNotMistakenForOutputs();
    void failureKeepsTheOldFile();
    void damagedRecordingGivesThePlanesOfItsRest();
    void scanOfOnlyZerosHasNoPlanes();
    void widestScanIsRead();
    void realRecordingsHavePlanes_data();
    void realRecordingsHavePlanes();

private:
    ProgramRun extract(const QStringList& options) const
    {
        return runProgram(QStringList{"extract", scan_} + options, folder_.path());
    }
    QString path(const QString& name) const { return folder_.filePath(name); }

    QTemporaryDir scans_;
    QString scan_;
    QTemporaryDir folder_;
};

void CliExtractTest::initTestCase()
{
    QCOMPARE(simulateTwelve(scans_.path()).code, 0);
    scan_ = scans_.filePath("scan.csv");
}

void CliExtractTest::writesEveryKindOfOutput()
{
    const ProgramRun run =
        extract({"--planes", "a.csv", "--planes", "a.json", "--planes", "a.ply", "--planes", "a.obj", "--segments",
                 "s.csv", "--points", "p.ply", "--labels", "labels", "--history", "h.ndjson", "--stats", "stats.json"});
    const ProgramRun others = extract({"--segments", "s.ply", "--points", "p.pcd"});

    QCOMPARE(run.code, 0);
    QCOMPARE(run.out + run.err, QByteArray());
    QCOMPARE(others.code, 0);
    QVERIFY(bytesOf(path("a.csv")).startsWith("# format = planewright-planes 1\nid,nx,"));
    QCOMPARE(QJsonDocument::fromJson(bytesOf(path("a.json")))["program"].toString(),
             "planewright " PLANEWRIGHT_VERSION);
    QVERIFY(bytesOf(path("a.ply")).startsWith("ply\nformat binary_little_endian"));
    QVERIFY(bytesOf(path("a.obj")).contains("\ng "));
    QVERIFY(bytesOf(path("s.csv")).startsWith("step,segment,"));
    QVERIFY(bytesOf(path("s.ply")).contains("element edge"));
    QVERIFY(bytesOf(path("p.ply")).startsWith("ply\n"));
    QVERIFY(bytesOf(path("p.pcd")).contains("FIELDS x y z label step"));
    QCOMPARE(bytesOf(path("labels")).count('\n'), 80);
    QVERIFY(bytesOf(path("h.ndjson")).startsWith("{\"format\":\"planewright-history 1\""));
    QVERIFY(bytesOf(path("stats.json")).startsWith("{\"format\":\"planewright-stats 1\""));
}

void CliExtractTest::withoutOutputsPrintsATable()
{
    const ProgramRun run = extract({});
    const QList<QByteArray> lines = run.out.split('\n');

    QCOMPARE(run.code, 0);
    QVERIFY(lines[0].contains("nx") && lines[0].contains("segments"));
    QCOMPARE(lines.size() - 2, 12);
}

void CliExtractTest::untilIsAsIfTheScanHadEndedThere()
{
    const QList<QByteArray> lines = bytesOf(scan_).split('\n');
    const qsizetype head = 9;
    writeBytes(path("first.csv"), lines.mid(0, head + 41).join('\n') + "\n");

    const ProgramRun part = extract({"--until", "40", "--planes", "until.csv", "--labels", "until.labels"});
    const ProgramRun whole =
        runProgram({"extract", "first.csv", "--planes", "whole.csv", "--labels", "whole.labels"}, folder_.path());

    QCOMPARE(part.code, 0);
    QCOMPARE(whole.code, 0);
    QCOMPARE(bytesOf(path("until.labels")).count('\n'), 41);
    QCOMPARE(bytesOf(path("until.csv")), bytesOf(path("whole.csv")));
    QCOMPARE(bytesOf(path("until.labels")), bytesOf(path("whole.labels")));
}

void CliExtractTest::untilBeforeTheFirstStepIsAnError()
{
    QByteArray text = recordingText(2, 3, 1500);
    text.replace("\n0,0.000000", "\n5,0.000000").replace("\n1,0.025000", "\n6,0.025000");
    writeBytes(path("late.csv"), text);

    const ProgramRun run = runProgram({"extract", "late.csv", "--until", "4"}, folder_.path());

    QCOMPARE(run.code, 2);
    QCOMPARE(run.err, QByteArray("planewright-cli: --until: the recording begins with step 5, give that or a later "
                                 "one\n"));
}

void CliExtractTest::noiseToldFarTooSmallIsWarnedOf()
{
    runProgram({"simulate", "twelve", "-o", "noisy.csv", "--tilt", "10:170:4", "--bearing", "0:180:0.5"},
               folder_.path());
    const auto withTold = [&](const QString& constant) {
        return runProgram({"extract", "noisy.csv", "-P", "noise.estimated=false", "-P", "noise.range-proportional=0",
                           "-P", "noise.range-constant=" + constant},
                          folder_.path());
    };

    const ProgramRun small = withTold("0.001");
    const ProgramRun right = withTold("0.008");
    const ProgramRun found = runProgram({"extract", "noisy.csv", "-P", "noise.range-constant=0.001"}, folder_.path());

    QCOMPARE(small.code, 0);
    QVERIFY2(small.err.startsWith("planewright-cli: warning: noisy.csv: ranges scatter by "), small.err);
    QVERIFY2(small.err.contains(", where 1.0 mm are told: "), small.err);
    QCOMPARE(right.err, QByteArray());
    QCOMPARE(found.err, QByteArray());
}

void CliExtractTest::historyHasALinePerStepAndTheLastPass()
{
    const ProgramRun plain = extract({"--history", "plain.ndjson"});
    const ProgramRun timed = extract({"--history", "timed.ndjson", "--history-times"});
    const QList<QByteArray> lines = bytesOf(path("plain.ndjson")).split('\n');

    QCOMPARE(plain.code, 0);
    QCOMPARE(timed.code, 0);
    QCOMPARE(lines.size(), 1 + 80 + 1 + 1);
    for (int step = 0; step < 80; ++step)
        QCOMPARE(QJsonDocument::fromJson(lines[step + 1])["step"].toInt(), step);
    const QJsonDocument last = QJsonDocument::fromJson(lines[81]);
    QCOMPARE(last["step"].toInt(), -1);
    QCOMPARE(last["phase"].toString(), "finish");
    QVERIFY(bytesOf(path("plain.ndjson")).contains("\"kind\":\"fit\""));
    QVERIFY(!lines[1].contains("times_ms"));
    QVERIFY(bytesOf(path("timed.ndjson")).contains("\"times_ms\""));
}

void CliExtractTest::statsCountWhatThePlanesHold()
{
    const ProgramRun run = extract({"--stats", "counts.json", "--labels", "counts.labels", "--repeat", "3"});
    const QJsonDocument stats = QJsonDocument::fromJson(bytesOf(path("counts.json")));

    QCOMPARE(run.code, 0);
    QCOMPARE(stats["points"].toInt(), 80 * 361);
    QCOMPARE(stats["planes"].toInt(), 12);
    QCOMPARE(stats["repeats"].toInt(), 3);
    QCOMPARE(stats["fitted"].toInt() + stats["unfitted"].toInt(), stats["segments"].toInt());
    QVERIFY(qAbs(stats["dar_percent"].toDouble() - 200.0 * stats["segments"].toInt() / (80 * 361)) < 1e-6);
    int returns = 0;
    for (const QByteArray& line : bytesOf(scan_).split('\n')) {
        const QList<QByteArray> cells = line.split(',');
        for (qsizetype i = 3; i < cells.size() && cells[3] != "r0"; ++i)
            returns += cells[i] == "0" ? 0 : 1;
    }
    QCOMPARE(stats["returns"].toInt(), returns);
    QVERIFY(stats["time_ms"]["total"].toDouble() > 0.0);
    QVERIFY(stats["step_ms"]["max"].toDouble() >= stats["step_ms"]["p50"].toDouble());
}

void CliExtractTest::unknownKindOfOutputIsWrongUsage_data()
{
    QTest::addColumn<QStringList>("options");
    QTest::addColumn<QString>("message");
    QTest::newRow("planes") << QStringList{"--planes", "x.stl"}
                            << "x.stl: the name of the planes tells its kind; known are .csv, .json, .ply, .obj, .dxf";
    QTest::newRow("segments") << QStringList{"--segments", "x.obj"}
                              << "x.obj: the name of the segments tells its kind; known are .csv, .ply";
    QTest::newRow("points") << QStringList{"--points", "x"}
                            << "x: the name of the points tells its kind; known are .ply, .pcd";
}

void CliExtractTest::unknownKindOfOutputIsWrongUsage()
{
    QFETCH(QStringList, options);
    QFETCH(QString, message);

    const ProgramRun run = extract(QStringList{"--labels", "unknown.labels"} + options);

    QCOMPARE(run.code, 2);
    QCOMPARE(QString::fromUtf8(run.err), "planewright-cli: " + message + "\n");
    QVERIFY(!QFile::exists(path("unknown.labels")));
}

void CliExtractTest::existingOutputIsKeptWithoutOverwrite()
{
    writeBytes(path("kept.csv"), "old");

    const ProgramRun refused = extract({"--labels", "not-made", "--planes", "kept.csv"});
    const QByteArray between = bytesOf(path("kept.csv"));
    const ProgramRun done = extract({"--planes", "kept.csv", "--overwrite"});

    QCOMPARE(refused.code, 5);
    QCOMPARE(refused.err, QByteArray("planewright-cli: kept.csv: the file exists; give --overwrite to replace it, or "
                                     "another name\n"));
    QCOMPARE(between, QByteArray("old"));
    QVERIFY(!QFile::exists(path("not-made")));
    QCOMPARE(done.code, 0);
    QVERIFY(bytesOf(path("kept.csv")).startsWith("# format"));
}

void CliExtractTest::whatIsThereIsNotDoneAgain()
{
    const QStringList options{"--planes", "once.csv", "--labels", "once.labels", "--skip-existing"};
    QCOMPARE(extract(options).code, 0);
    const QByteArray planes = bytesOf(path("once.csv"));
    QVERIFY(planes.startsWith("# format"));

    // All are there: nothing is even read.
    writeBytes(path("once.csv"), "kept");
    QCOMPARE(extract(options).code, 0);
    QCOMPARE(bytesOf(path("once.csv")), QByteArray("kept"));

    // One is missing: all are written.
    QVERIFY(QFile::remove(path("once.labels")));
    QCOMPARE(extract(options).code, 0);
    QCOMPARE(bytesOf(path("once.csv")), planes);
    QVERIFY(QFile::exists(path("once.labels")));
}

void CliExtractTest::twoOutputsMayNotBeOneFile()
{
    const ProgramRun run = extract({"--planes", "same.csv", "--segments", "./same.csv"});

    QCOMPARE(run.code, 2);
    QCOMPARE(run.err, QByteArray("planewright-cli: ./same.csv: two outputs go to this file (same.csv); give each its "
                                 "own name\n"));
    QVERIFY(!QFile::exists(path("same.csv")));
}

void CliExtractTest::outputThatCannotBeWrittenLeavesNothing_data()
{
    QTest::addColumn<QString>("target");
    QTest::addColumn<QString>("message");
    const QString full = ": No space left on device; free some space or write to another disk";
    QTest::newRow("full device") << "/dev/full"
                                 << "/dev/full" + full;
    QTest::newRow("link to a full device") << "full"
                                           << "full" + full;
    QTest::newRow("no such folder") << "no/such/file"
                                    << "no/such/file: there is no such folder; create it first";
    QTest::newRow("a folder") << "."
                              << ".: this is a folder; give the name of a file in it";
    QTest::newRow("a place that takes no files") << "/proc/file"
                                                 << "/proc/file: there is no such folder; create it first";
}

void CliExtractTest::outputThatCannotBeWrittenLeavesNothing()
{
    QFETCH(QString, target);
    QFETCH(QString, message);
    const QTemporaryDir folder;
    QVERIFY(QFile::link("/dev/full", folder.filePath("full")));

    for (const char* option : {"--labels", "--history", "--stats"}) {
        const ProgramRun run = runProgram({"extract", scan_, "--planes", "planes.csv", option, target}, folder.path());

        QCOMPARE(run.code, 5);
        QCOMPARE(QString::fromUtf8(run.err), "planewright-cli: " + message + "\n");
        QCOMPARE(QDir(folder.path()).entryList(QDir::Files | QDir::Hidden | QDir::System), QStringList{"full"});
    }
}

void CliExtractTest::limitOnFileSizesLeavesNothing()
{
    const QTemporaryDir folder;
    QProcess shell;
    shell.setWorkingDirectory(folder.path());

    shell.start("/bin/sh", {"-c", "ulimit -f 1; exec '" PLANEWRIGHT_CLI "' extract '" + scan_ +
                                      "' --planes p.csv --labels l --points p.ply"});
    shell.waitForFinished(-1);

    QCOMPARE(shell.exitStatus(), QProcess::NormalExit);
    QCOMPARE(shell.exitCode(), 5);
    // A build for coverage complains there too that its own files may not grow.
    QCOMPARE(shell.readAllStandardError().count("planewright-cli: "), 1);
    QCOMPARE(QDir(folder.path()).entryList(QDir::Files | QDir::Hidden), QStringList{});
}

void CliExtractTest::closedStandardStreamsAreNotMistakenForOutputs()
{
    const QTemporaryDir folder;
    QProcess shell;
    shell.setWorkingDirectory(folder.path());

    shell.start("/bin/sh", {"-c", "exec '" PLANEWRIGHT_CLI "' extract '" + scan_ + "' --labels l >&- 2>&- <&-"});
    shell.waitForFinished(-1);

    QCOMPARE(shell.exitCode(), 0);
    QCOMPARE(bytesOf(folder.filePath("l")).count('\n'), 80);
}

void CliExtractTest::standardOutputMayBeAnOutput()
{
    const ProgramRun stats = extract({"--stats", "/dev/stdout"});
    const ProgramRun piped = extract({"--labels", "/proc/self/fd/1"});

    QCOMPARE(stats.code, 0);
    QVERIFY(stats.out.startsWith("{\"format\":\"planewright-stats 1\""));
    QCOMPARE(piped.code, 0);
    QCOMPARE(piped.out.count('\n'), 80);
}

void CliExtractTest::failureKeepsTheOldFile()
{
    writeBytes(path("old.csv"), "old");

    const ProgramRun run = extract({"--planes", "old.csv", "--labels", "/dev/full", "--overwrite"});

    QCOMPARE(run.code, 5);
    QCOMPARE(bytesOf(path("old.csv")), QByteArray("old"));
}

void CliExtractTest::damagedRecordingGivesThePlanesOfItsRest()
{
    const QByteArray whole = bytesOf(scan_);
    writeBytes(path("cut.csv"), whole.left(whole.size() - 10));

    const ProgramRun run = runProgram({"extract", "cut.csv", "--labels", "cut.labels"}, folder_.path());

    QCOMPARE(run.code, 4);
    QCOMPARE(run.err.count('\n'), 1);
    QVERIFY(run.err.startsWith("planewright-cli: warning: cut.csv: line 89: the last row was cut short"));
    QCOMPARE(bytesOf(path("cut.labels")).count('\n'), 79);
}

void CliExtractTest::scanOfOnlyZerosHasNoPlanes()
{
    writeBytes(path("zeros.csv"), recordingText(30, 100, 0));

    const ProgramRun run =
        runProgram({"extract", "zeros.csv", "--planes", "zeros-planes.csv", "--planes", "zeros.ply", "--planes",
                    "zeros.json", "--planes", "zeros.obj", "--points", "zeros-points.ply", "--stats", "zeros-stats"},
                   folder_.path());
    const ProgramRun table = runProgram({"extract", "zeros.csv"}, folder_.path());

    QCOMPARE(run.code, 0);
    QCOMPARE(bytesOf(path("zeros-planes.csv")).count('\n'), 2);
    QCOMPARE(QJsonDocument::fromJson(bytesOf(path("zeros-stats")))["planes"].toInt(-1), 0);
    QCOMPARE(table.code, 0);
    QCOMPARE(table.out, QByteArray("no planes\n"));
}

void CliExtractTest::widestScanIsRead()
{
    QByteArray text = recordingText(2, 65536, 1500);
    text.replace("bearing_step_deg = 1\n", "bearing_step_deg = 0.004\n");
    writeBytes(path("wide.csv"), text);

    const ProgramRun run = runProgram({"extract", "wide.csv", "--labels", "wide.labels"}, folder_.path());

    QCOMPARE(run.code, 0);
    QCOMPARE(bytesOf(path("wide.labels")).split('\n')[0].count(' '), 65535);
}

void CliExtractTest::realRecordingsHavePlanes_data()
{
    QTest::addColumn<QString>("name");
    QTest::newRow("lobby") << "lobby.csv.gz";
    QTest::newRow("desk") << "desk.csv.gz";
}

void CliExtractTest::realRecordingsHavePlanes()
{
    QFETCH(QString, name);
    const QString recording = realRecording(name);
    QVERIFY(!recording.isEmpty());

    const ProgramRun run = runProgram({"extract", recording});

    QCOMPARE(run.code, 0);
    QCOMPARE(run.err, QByteArray());
    QVERIFY(run.out.count('\n') > 3);
}

PLANEWRIGHT_TEST(CliExtractTest)
#include "cli_extract_test.moc"
