// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <sys/stat.h>

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>

#include "run_program.h"
#include "tests/test_program.h"

class CliInfoTest : public QObject {
    Q_OBJECT

private slots:
    void saysWhatAFileHolds();
    void recordingWithoutAScannerIsSaidToNameNone();
    void jsonSaysTheSame();
    void oneBadFileDoesNotSilenceTheOthers();
    void damagedFileExitsWithFour();
    void refusesWhatIsNoRegularFile_data();
    void refusesWhatIsNoRegularFile();
};

void CliInfoTest::saysWhatAFileHolds()
{
    const QTemporaryDir folder;
    writeBytes(folder.filePath("a.csv"), recordingText(3, 4, 1500));

    const ProgramRun run = runProgram({"info", "a.csv"}, folder.path());
    const QString out = QString::fromUtf8(run.out).simplified();

    QCOMPARE(run.code, 0);
    for (const char* fact :
         {"scanner UTM-30LX", "slices 3", "beams in a slice 4", "points 12", "returns 12", "nearest return [m] 1.5",
          "first pitch [deg] 60", "last pitch [deg] 62", "largest range [m] 30", "duration [s] 0.05", "damaged no"})
        QVERIFY2(out.contains(fact), run.out);
}

void CliInfoTest::recordingWithoutAScannerIsSaidToNameNone()
{
    const QTemporaryDir folder;
    writeBytes(folder.filePath("a.csv"), recordingText(3, 4, 1500, ""));

    const ProgramRun run = runProgram({"info", "a.csv"}, folder.path());

    QCOMPARE(run.code, 0);
    QVERIFY2(QString::fromUtf8(run.out).simplified().contains("scanner not given slices 3"), run.out);
}

void CliInfoTest::jsonSaysTheSame()
{
    const QTemporaryDir folder;
    writeBytes(folder.filePath("a.csv"), "# place = cellar\n" + recordingText(3, 4, 31000));

    const ProgramRun run = runProgram({"info", "a.csv", "--json"}, folder.path());
    const QJsonObject file = QJsonDocument::fromJson(run.out).array()[0].toObject();

    QCOMPARE(run.code, 0);
    QCOMPARE(file["file"].toString(), "a.csv");
    QCOMPARE(file["slices"].toInt(), 3);
    QCOMPARE(file["points"].toInt(), 12);
    QCOMPARE(file["returns"].toInt(), 0);
    QCOMPARE(file["extra"].toObject()["place"].toString(), "cellar");
}

void CliInfoTest::oneBadFileDoesNotSilenceTheOthers()
{
    const QTemporaryDir folder;
    writeBytes(folder.filePath("a.csv"), recordingText(3, 4, 1500));

    const ProgramRun run = runProgram({"info", "missing.csv", "a.csv", "--json"}, folder.path());

    QCOMPARE(run.code, 3);
    QCOMPARE(run.err, QByteArray("planewright-cli: missing.csv: there is no such file; check its name and folder\n"));
    QCOMPARE(QJsonDocument::fromJson(run.out).array().size(), 1);
}

void CliInfoTest::damagedFileExitsWithFour()
{
    const QTemporaryDir folder;
    const QByteArray whole = recordingText(3, 4, 1500);
    writeBytes(folder.filePath("a.csv"), whole.left(whole.size() - 8));

    const ProgramRun run = runProgram({"info", "a.csv", "--json"}, folder.path());

    QCOMPARE(run.code, 4);
    QCOMPARE(QJsonDocument::fromJson(run.out).array()[0].toObject()["damaged"].toBool(), true);
}

void CliInfoTest::refusesWhatIsNoRegularFile_data()
{
    QTest::addColumn<QString>("target");
    QTest::addColumn<QString>("says");
    QTest::newRow("folder") << "/tmp"
                            << "this is a folder; give a file in it";
    QTest::newRow("device") << "/dev/zero"
                            << "this is a device or pipe; give a regular file";
    QTest::newRow("pipe") << "pipe"
                          << "this is a device or pipe; give a regular file";
}

void CliInfoTest::refusesWhatIsNoRegularFile()
{
    QFETCH(QString, target);
    QFETCH(QString, says);
    const QTemporaryDir folder;
    QVERIFY(::mkfifo(folder.filePath("pipe").toLocal8Bit().constData(), 0600) == 0);
    QVERIFY(QFile::link(target, folder.filePath("a.csv")));

    const ProgramRun run = runProgram({"info", "a.csv"}, folder.path());

    QCOMPARE(run.code, 3);
    QCOMPARE(QString::fromUtf8(run.err), "planewright-cli: a.csv: " + says + "\n");
}

PLANEWRIGHT_TEST(CliInfoTest)
#include "cli_info_test.moc"
