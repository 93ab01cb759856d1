// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <QTemporaryDir>
#include <QTest>

#include "run_program.h"
#include "tests/test_program.h"

class CliConvertTest : public QObject {
    Q_OBJECT

private slots:
    void writesTheSameRecordingCompressedAndBack();
    void keepsKeysThatItDoesNotKnow();
    void unknownKindIsAnError_data();
    void unknownKindIsAnError();
    void damagedInputIsConvertedInPart();
    void ontoItselfIsAnError();
};

void CliConvertTest::writesTheSameRecordingCompressedAndBack()
{
    const QTemporaryDir folder;
    writeBytes(folder.filePath("a.csv"), recordingText(3, 4, 1500));
    runProgram({"convert", "a.csv", "b.csv"}, folder.path());

    const ProgramRun there = runProgram({"convert", "b.csv", "b.csv.gz"}, folder.path());
    const ProgramRun back = runProgram({"convert", "b.csv.gz", "c.csv"}, folder.path());

    QCOMPARE(there.code, 0);
    QCOMPARE(back.code, 0);
    QVERIFY(!bytesOf(folder.filePath("b.csv")).isEmpty());
    QCOMPARE(bytesOf(folder.filePath("c.csv")), bytesOf(folder.filePath("b.csv")));
}

void CliConvertTest::keepsKeysThatItDoesNotKnow()
{
    const QTemporaryDir folder;
    writeBytes(folder.filePath("a.csv"), "# serial = H123\n" + recordingText(1, 2, 1500));

    const ProgramRun run = runProgram({"convert", "a.csv", "b.csv"}, folder.path());

    QCOMPARE(run.code, 0);
    QCOMPARE(run.err,
             QByteArray("planewright-cli: warning: a.csv: line 1 (serial): the key is not known; it is kept and not "
                        "used\n"));
    QVERIFY(bytesOf(folder.filePath("b.csv")).contains("# serial = H123\n"));
}

void CliConvertTest::unknownKindIsAnError_data()
{
    QTest::addColumn<QString>("from");
    QTest::addColumn<QString>("to");
    QTest::addColumn<QString>("message");
    QTest::newRow("output") << "a.csv"
                            << "b.xyz"
                            << "b.xyz: the name of a recording tells its kind; known are .csv, .csv.gz, .pwscan";
    QTest::newRow("input") << "a.bag"
                           << "b.csv"
                           << "a.bag: the name of a recording tells its kind; known are .csv, .csv.gz, .pwscan, "
                              ".pcd, .ptx, .3d";
    QTest::newRow("no suffix") << "a"
                               << "b.csv"
                               << "a: the name of a recording tells its kind; known are .csv, .csv.gz, .pwscan, "
                                  ".pcd, .ptx, .3d";
}

void CliConvertTest::unknownKindIsAnError()
{
    QFETCH(QString, from);
    QFETCH(QString, to);
    QFETCH(QString, message);
    const QTemporaryDir folder;
    for (const char* name : {"a", "a.csv", "a.bag"})
        writeBytes(folder.filePath(name), recordingText(1, 1, 1500));

    const ProgramRun run = runProgram({"convert", from, to}, folder.path());

    QCOMPARE(run.code, 2);
    QCOMPARE(QString::fromUtf8(run.err), "planewright-cli: " + message + "\n");
    QVERIFY(bytesOf(folder.filePath(to)).isNull());
}

void CliConvertTest::damagedInputIsConvertedInPart()
{
    const QTemporaryDir folder;
    const QByteArray whole = recordingText(3, 4, 1500);
    writeBytes(folder.filePath("a.csv"), whole.left(whole.size() - 8));

    const ProgramRun run = runProgram({"convert", "a.csv", "b.csv"}, folder.path());

    QCOMPARE(run.code, 4);
    QVERIFY(run.err.contains("the last row was cut short"));
    QVERIFY(bytesOf(folder.filePath("b.csv")).contains("\n1,"));
    QVERIFY(!bytesOf(folder.filePath("b.csv")).contains("\n2,"));
}

void CliConvertTest::ontoItselfIsAnError()
{
    const QTemporaryDir folder;
    const QByteArray recording = recordingText(1, 1, 1500);
    writeBytes(folder.filePath("a.csv"), recording);

    const ProgramRun run = runProgram({"convert", "a.csv", "./a.csv", "--overwrite"}, folder.path());

    QCOMPARE(run.code, 2);
    QCOMPARE(run.err, QByteArray("planewright-cli: ./a.csv: this is the input; give another name for the output\n"));
    QCOMPARE(bytesOf(folder.filePath("a.csv")), recording);
}

PLANEWRIGHT_TEST(CliConvertTest)
#include "cli_convert_test.moc"
