// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <QDir>
#include <QTemporaryDir>
#include <QTest>

#include "run_program.h"
#include "tests/test_program.h"

class CliSimulateTest : public QObject {
    Q_OBJECT

private slots:
    void writesRecordingTruthAndLabels();
    void defaultsAreTableVIII();
    void slicesOverrideTheTilt();
    void bearingsCountBothEnds();
    void theSameSeedGivesTheSameBytes();
    void dropoutOverridesTheProfile();
    void compressedRecordingReadsBackTheSame();
    void wrongArgumentsWriteNothing_data();
    void wrongArgumentsWriteNothing();
    void existingRecordingIsKeptWithoutOverwrite();
};

void CliSimulateTest::writesRecordingTruthAndLabels()
{
    const QTemporaryDir folder;

    const ProgramRun run = simulateTwelve(folder.path());
    const QList<QByteArray> labels = bytesOf(folder.filePath("truth.labels")).split('\n');
    const QList<QByteArray> truth = bytesOf(folder.filePath("truth.csv")).split('\n');

    QCOMPARE(run.code, 0);
    QCOMPARE(run.err, QByteArray());
    QVERIFY(bytesOf(folder.filePath("scan.csv")).contains("\n# beams = 361\n"));
    QCOMPARE(labels.size(), 80 + 1);
    QCOMPARE(labels[0].split(' ').size(), 361);
    QCOMPARE(truth.size(), 1 + 1 + 12 + 1);
    const qsizetype points = truth[1].split(',').indexOf("points");
    int returns = 0;
    for (const QByteArray& line : labels)
        returns += static_cast<int>(line.split(' ').count("0"));
    QVERIFY(returns > 0);
    QCOMPARE(truth[2].split(',')[points].toInt(), returns);
}

void CliSimulateTest::defaultsAreTableVIII()
{
    const QTemporaryDir folder;

    const ProgramRun run = runProgram({"simulate", "empty", "-o", "scan.csv", "--truth-labels", "l"}, folder.path());
    const QByteArray recording = bytesOf(folder.filePath("scan.csv"));

    QCOMPARE(run.code, 0);
    QVERIFY(recording.contains("\n# beams = 721\n"));
    QVERIFY(recording.contains("\n# bearing_step_deg = 0.25\n"));
    QVERIFY(recording.contains("\n136,"));
    QVERIFY(!recording.contains("\n137,"));
    QCOMPARE(bytesOf(folder.filePath("l")).count('\n'), 137);
}

void CliSimulateTest::slicesOverrideTheTilt()
{
    const QTemporaryDir folder;

    const ProgramRun run = runProgram({"simulate", "empty", "-o", "scan.csv", "--truth-labels", "l", "--tilt",
                                       "-10:170:1", "--slices", "7", "--bearing", "0:10:1"},
                                      folder.path());

    QCOMPARE(run.code, 0);
    QCOMPARE(bytesOf(folder.filePath("l")).count('\n'), 7);
    QVERIFY(bytesOf(folder.filePath("scan.csv")).contains("\n0,0.000000,-10,"));
}

void CliSimulateTest::bearingsCountBothEnds()
{
    const QTemporaryDir folder;

    runProgram({"simulate", "empty", "-o", "scan.csv", "--tilt", "10:12:1", "--bearing", "-45:225:0.25"},
               folder.path());

    QVERIFY(bytesOf(folder.filePath("scan.csv")).contains("\n# beams = 1081\n"));
}

void CliSimulateTest::theSameSeedGivesTheSameBytes()
{
    const QTemporaryDir folder;
    const auto simulate = [&](const QString& file, const QString& seed) {
        runProgram({"simulate", "corridor", "-o", file, "--seed", seed, "--tilt", "60:120:10", "--bearing", "0:180:2"},
                   folder.path());
        return bytesOf(folder.filePath(file));
    };

    const QByteArray first = simulate("a.csv", "5");
    const QByteArray again = simulate("b.csv", "5");
    const QByteArray other = simulate("c.csv", "6");

    QVERIFY(!first.isEmpty());
    QCOMPARE(again, first);
    QVERIFY(other != first);
}

void CliSimulateTest::dropoutOverridesTheProfile()
{
    const QTemporaryDir folder;

    runProgram({"simulate", "office", "-o", "a.csv", "--dropout", "100", "--tilt", "60:120:10", "--bearing", "0:180:2",
                "--truth-labels", "l"},
               folder.path());

    const QByteArray labels = bytesOf(folder.filePath("l"));
    QVERIFY(!labels.isEmpty());
    QVERIFY(!labels.contains('0') && !labels.contains('2'));
}

void CliSimulateTest::compressedRecordingReadsBackTheSame()
{
    const QTemporaryDir folder;
    const QStringList common{"--tilt", "60:120:10", "--bearing", "0:180:2"};
    runProgram(QStringList{"simulate", "office", "-o", "a.csv"} + common, folder.path());
    runProgram(QStringList{"simulate", "office", "-o", "a.csv.gz"} + common, folder.path());

    const ProgramRun run = runProgram({"convert", "a.csv.gz", "b.csv"}, folder.path());

    QCOMPARE(run.code, 0);
    QCOMPARE(bytesOf(folder.filePath("a.csv.gz")).left(2), QByteArray("\x1f\x8b"));
    QCOMPARE(bytesOf(folder.filePath("b.csv")), bytesOf(folder.filePath("a.csv")));
}

void CliSimulateTest::wrongArgumentsWriteNothing_data()
{
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<QString>("names");
    QTest::newRow("scene") << QStringList{"cathedral"} << "corridor";
    QTest::newRow("noise") << QStringList{"office", "--noise", "X"} << "default";
    QTest::newRow("dropout") << QStringList{"office", "--dropout", "101"} << "--dropout";
    QTest::newRow("tilt") << QStringList{"office", "--tilt", "1:2"} << "--tilt";
    QTest::newRow("bearing down") << QStringList{"office", "--bearing", "180:0:-1"} << "--bearing";
    QTest::newRow("slices") << QStringList{"office", "--slices", "65537"} << "--slices";
    QTest::newRow("tilt beyond a turn") << QStringList{"office", "--slices", "65536"} << "--slices";
    QTest::newRow("seed") << QStringList{"office", "--seed", "-1"} << "--seed";
    QTest::newRow("truth that is no csv") << QStringList{"office", "--truth", "t.txt"} << "t.txt";
    QTest::newRow("too many points") << QStringList{"office", "--tilt", "0:170:0.0026", "--bearing", "0:180:0.0028"}
                                     << "points";
}

void CliSimulateTest::wrongArgumentsWriteNothing()
{
    QFETCH(QStringList, arguments);
    QFETCH(QString, names);
    const QTemporaryDir folder;

    const ProgramRun run = runProgram(QStringList{"simulate"} + arguments + QStringList{"-o", "a.csv"}, folder.path());

    QCOMPARE(run.code, 2);
    QVERIFY2(QString::fromUtf8(run.err).contains(names), run.err);
    QCOMPARE(QDir(folder.path()).entryList(QDir::Files | QDir::Hidden), QStringList{});
}

void CliSimulateTest::existingRecordingIsKeptWithoutOverwrite()
{
    const QTemporaryDir folder;
    writeBytes(folder.filePath("scan.csv"), "old");

    const ProgramRun refused = runProgram({"simulate", "empty", "-o", "scan.csv"}, folder.path());
    QCOMPARE(bytesOf(folder.filePath("scan.csv")), QByteArray("old"));
    const ProgramRun done = runProgram({"simulate", "empty", "-o", "scan.csv", "--overwrite"}, folder.path());

    QCOMPARE(refused.code, 5);
    QCOMPARE(done.code, 0);
    QVERIFY(bytesOf(folder.filePath("scan.csv")).startsWith("# format = nodding-laser-csv 1\n"));
}

PLANEWRIGHT_TEST(CliSimulateTest)
#include "cli_simulate_test.moc"
