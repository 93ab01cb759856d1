// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>

#include "run_program.h"
#include "tests/test_program.h"

class CliValidateTest : public QObject {
    Q_OBJECT

private slots:
    void validFileIsSaidToBe();
    void everyProblemIsListed();
    void malformedIsWorseThanDamaged();
    void jsonGivesAVerdictPerFile();
    void unknownKindIsWrongUsage();
};

void CliValidateTest::validFileIsSaidToBe()
{
    const QTemporaryDir folder;
    writeBytes(folder.filePath("a.csv"), recordingText(3, 4, 1500));

    const ProgramRun run = runProgram({"validate", "a.csv"}, folder.path());

    QCOMPARE(run.code, 0);
    QCOMPARE(run.out, QByteArray("a.csv: valid\n"));
}

void CliValidateTest::everyProblemIsListed()
{
    const QTemporaryDir folder;
    QByteArray text = recordingText(3, 4, 1500);
    text.replace("0,0.000000,60.00,1500", "0,0.000000,nan,1500");
    text.replace("2,0.050000,62.00,1500", "2,0.050000,62.00,15.5");
    writeBytes(folder.filePath("a.csv"), text);

    const ProgramRun run = runProgram({"validate", "a.csv"}, folder.path());

    QCOMPARE(run.code, 3);
    QVERIFY2(run.out.contains("a.csv: line 10, column 3 (pitch_deg): "), run.out);
    QVERIFY2(run.out.contains("a.csv: line 12, column 4 (r0): "), run.out);
    QVERIFY2(run.out.endsWith("a.csv: malformed\n"), run.out);
}

void CliValidateTest::malformedIsWorseThanDamaged()
{
    const QTemporaryDir folder;
    const QByteArray whole = recordingText(3, 4, 1500);
    writeBytes(folder.filePath("valid.csv"), whole);
    writeBytes(folder.filePath("damaged.csv"), whole.left(whole.size() - 8));
    writeBytes(folder.filePath("malformed.csv"), "x");

    QCOMPARE(runProgram({"validate", "valid.csv", "damaged.csv"}, folder.path()).code, 4);
    QCOMPARE(runProgram({"validate", "damaged.csv", "malformed.csv", "valid.csv"}, folder.path()).code, 3);
    QCOMPARE(runProgram({"validate", "malformed.csv", "damaged.csv"}, folder.path()).code, 3);
}

void CliValidateTest::jsonGivesAVerdictPerFile()
{
    const QTemporaryDir folder;
    writeBytes(folder.filePath("a.csv"), recordingText(3, 4, 1500));

    const ProgramRun run = runProgram({"validate", "--json", "a.csv", "missing.csv"}, folder.path());
    const QJsonArray files = QJsonDocument::fromJson(run.out).array();

    QCOMPARE(run.code, 3);
    QCOMPARE(files[0].toObject()["verdict"].toString(), "valid");
    QCOMPARE(files[0].toObject()["problems"].toArray().size(), 0);
    QCOMPARE(files[1].toObject()["verdict"].toString(), "unreadable");
    QCOMPARE(files[1].toObject()["problems"].toArray()[0].toString(),
             "missing.csv: there is no such file; check its name and folder");
}

void CliValidateTest::unknownKindIsWrongUsage()
{
    QCOMPARE(runProgram({"validate", "a.txt"}).code, 2);
}

PLANEWRIGHT_TEST(CliValidateTest)
#include "cli_validate_test.moc"
