// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <csignal>

#include <QFile>
#include <QProcess>
#include <QTemporaryDir>
#include <QtTest>

#include "run_program.h"
#include "tests/test_program.h"

class CliRecordTest : public QObject {
    Q_OBJECT

private slots:
    void whatIsRecordedGivesThePlanesOfTheSimulation();
    void aReplayIsRecordedAsItWas();
    void extractsMeanwhile();
    void takesAsManySlicesAsItIsToldTo();
    void aFileThatIsThereIsLeftAlone();
    void appendAddsAScan();
    void anInterruptClosesTheFile_data();
    void anInterruptClosesTheFile();
    void wrongUsageIsRefusedBeforeAnythingIsWritten_data();
    void wrongUsageIsRefusedBeforeAnythingIsWritten();
};

namespace {

ProgramRun run(const QTemporaryDir& folder, const QString& arguments)
{
    return runProgram(arguments.split(QLatin1Char(' ')), folder.path());
}

/// The lines of a CSV recording that are slices.
qsizetype slicesIn(const QByteArray& csv)
{
    qsizetype slices = 0;
    for (const QByteArray& line : csv.split('\n'))
        slices += !line.isEmpty() && line[0] >= '0' && line[0] <= '9' ? 1 : 0;
    return slices;
}

}  // namespace

void CliRecordTest::whatIsRecordedGivesThePlanesOfTheSimulation()
{
    const QTemporaryDir folder;

    const ProgramRun recorded =
        run(folder, "record --scanner sim:corridor?seed=3&speed=0 -o live.pwscan --tilt 10:170:4");
    QCOMPARE(recorded.err, QByteArray());
    QCOMPARE(recorded.code, 0);
    QCOMPARE(run(folder, "simulate corridor --seed 3 -o made.csv --tilt 10:170:4").code, 0);

    QCOMPARE(run(folder, "extract live.pwscan --planes live.csv").code, 0);
    QCOMPARE(run(folder, "extract made.csv --planes planes.csv").code, 0);
    QVERIFY(!bytesOf(folder.filePath("planes.csv")).isEmpty());
    QCOMPARE(bytesOf(folder.filePath("live.csv")), bytesOf(folder.filePath("planes.csv")));
    QVERIFY(!QFile::exists(folder.filePath("live.pwscan-wal")));
}

void CliRecordTest::aReplayIsRecordedAsItWas()
{
    const QTemporaryDir folder;
    writeBytes(folder.filePath("scan.csv"), recordingText(5, 9, 2000));

    QCOMPARE(run(folder, "record --scanner replay:scan.csv?speed=0 -o again.pwscan").code, 0);

    QCOMPARE(run(folder, "convert again.pwscan again.csv").code, 0);
    QCOMPARE(run(folder, "convert scan.csv same.csv").code, 0);
    QCOMPARE(bytesOf(folder.filePath("again.csv")), bytesOf(folder.filePath("same.csv")));
    QCOMPARE(slicesIn(bytesOf(folder.filePath("again.csv"))), qsizetype(5));
}

void CliRecordTest::extractsMeanwhile()
{
    const QTemporaryDir folder;

    const ProgramRun recorded = run(folder,
                                    "record --scanner sim:corridor?seed=3&speed=0 -o live.pwscan --tilt 10:170:4 "
                                    "--extract -P likelihood.enough-points=400");

    QCOMPARE(recorded.code, 0);
    QVERIFY(!recorded.out.isEmpty());
    const ProgramRun extracted = run(folder, "extract live.pwscan");
    QCOMPARE(extracted.code, 0);
    QCOMPARE(recorded.out, extracted.out);
}

void CliRecordTest::takesAsManySlicesAsItIsToldTo()
{
    const QTemporaryDir folder;

    QCOMPARE(run(folder, "record --scanner sim:empty?speed=0 -o a.pwscan --slices 7").code, 0);
    QCOMPARE(run(folder, "record --scanner sim:empty?speed=0 -o b.pwscan --tilt 90:100:1").code, 0);

    QCOMPARE(run(folder, "convert a.pwscan a.csv").code, 0);
    QCOMPARE(run(folder, "convert b.pwscan b.csv").code, 0);
    QCOMPARE(slicesIn(bytesOf(folder.filePath("a.csv"))), qsizetype(7));
    QCOMPARE(slicesIn(bytesOf(folder.filePath("b.csv"))), qsizetype(10));
}

void CliRecordTest::aFileThatIsThereIsLeftAlone()
{
    const QTemporaryDir folder;
    writeBytes(folder.filePath("live.pwscan"), "mine");

    const ProgramRun recorded = run(folder, "record --scanner sim:empty?speed=0 -o live.pwscan --slices 3");

    QCOMPARE(recorded.code, 5);
    QVERIFY(recorded.err.contains("--append"));
    QCOMPARE(bytesOf(folder.filePath("live.pwscan")), QByteArray("mine"));
}

void CliRecordTest::appendAddsAScan()
{
    const QTemporaryDir folder;

    QCOMPARE(run(folder, "record --scanner sim:empty?speed=0 -o live.pwscan --slices 3 --append").code, 0);
    QCOMPARE(run(folder, "record --scanner sim:empty?speed=0 -o live.pwscan --slices 4 --append").code, 0);

    QCOMPARE(run(folder, "convert live.pwscan last.csv").code, 0);
    QCOMPARE(run(folder, "convert live.pwscan first.csv --scan 1").code, 0);
    QCOMPARE(slicesIn(bytesOf(folder.filePath("first.csv"))), qsizetype(3));
    QCOMPARE(slicesIn(bytesOf(folder.filePath("last.csv"))), qsizetype(4));
}

void CliRecordTest::anInterruptClosesTheFile_data()
{
    QTest::addColumn<int>("signal");
    QTest::addColumn<int>("code");
    QTest::newRow("SIGINT") << SIGINT << 130;
    QTest::newRow("SIGTERM") << SIGTERM << 143;
}

void CliRecordTest::anInterruptClosesTheFile()
{
    QFETCH(int, signal);
    QFETCH(int, code);
    const QTemporaryDir folder;
    QProcess process;
    process.setWorkingDirectory(folder.path());
    // Longer than any test waits.
    process.start(PLANEWRIGHT_CLI, {"record", "--scanner", "sim:corridor?speed=1", "-o", "live.pwscan", "--tilt",
                                    "10:170:0.01", "--extract"});
    QTRY_VERIFY_WITH_TIMEOUT(QFile(folder.filePath("live.pwscan-wal")).size() > 100'000, 60'000);

    ::kill(static_cast<pid_t>(process.processId()), signal);
    QVERIFY(process.waitForFinished(60'000));

    QCOMPARE(process.exitStatus(), QProcess::NormalExit);
    QCOMPARE(process.exitCode(), code);
    QVERIFY(!QFile::exists(folder.filePath("live.pwscan-wal")));
    QCOMPARE(run(folder, "validate live.pwscan").code, 0);
    QCOMPARE(run(folder, "extract live.pwscan --planes planes.csv").code, 0);
}

void CliRecordTest::wrongUsageIsRefusedBeforeAnythingIsWritten_data()
{
    QTest::addColumn<QString>("arguments");
    QTest::addColumn<QByteArray>("says");
    const auto row = [](const char* name, const QString& arguments, const char* says) {
        QTest::newRow(name) << arguments << QByteArray(says);
    };
    row("unknown scene", "--scanner sim:cathedral -o a.pwscan", "Known: corridor");
    row("unknown key", "--scanner sim:hall?sped=1 -o a.pwscan", "known: seed, speed");
    row("a file is no scanner", "--scanner scan.csv -o a.pwscan", "replay:scan.csv");
    row("a laser", "--scanner usb: -o a.pwscan", "--tilt-unit");
    row("not .pwscan", "--scanner sim:hall -o a.csv", ".pwscan");
    row("tilts of a replay", "--scanner replay:a.csv -o a.pwscan --slices 3", "leave them out");
    row("beyond a turn", "--scanner sim:hall -o a.pwscan --slices 60000", "give fewer");
    row("parameters without planes", "--scanner sim:hall -o a.pwscan --preset paper", "--extract");
}

void CliRecordTest::wrongUsageIsRefusedBeforeAnythingIsWritten()
{
    QFETCH(QString, arguments);
    QFETCH(QByteArray, says);
    const QTemporaryDir folder;

    const ProgramRun recorded = run(folder, "record " + arguments);

    QCOMPARE(recorded.code, 2);
    QVERIFY2(recorded.err.contains(says), recorded.err.constData());
    QVERIFY(!QFile::exists(folder.filePath("a.pwscan")));
}

PLANEWRIGHT_TEST(CliRecordTest)
#include "cli_record_test.moc"
