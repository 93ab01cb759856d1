// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>

#include "run_program.h"
#include "tests/test_program.h"

class CliCalibrateTest : public QObject {
    Q_OBJECT

private slots:
    void printsWhatItFinds();
    void theSensorFileCorrectsExtraction();
    void keepsASensorFileUnlessToldOtherwise();
    void realRecordingsAreSaidToTellWhatTheyTell_data();
    void realRecordingsAreSaidToTellWhatTheyTell();
    void withoutPlanesNothingIsWritten();
    void aScanThatTellsNothingIsNamed();
    void wrongUseIsAnError_data();
    void wrongUseIsAnError();
    void aDamagedRecordingIsUsedInPart();
};

namespace {

/// A hall whose scanner measures 2 degrees too little pitch, in a folder as scan.csv.
void simulateHall(const QString& folder)
{
    runProgram({"simulate", "hall", "-o", "right.csv", "--seed", "3", "--truth", "truth.csv"}, folder);
    QList<QByteArray> lines = bytesOf(folder + "/right.csv").split('\n');
    for (QByteArray& line : lines) {
        QList<QByteArray> cells = line.split(',');
        if (line.startsWith('#') || line.startsWith("slice") || cells.size() < 3)
            continue;
        cells[2] = QByteArray::number(cells[2].toDouble() - 2.0, 'f', 6);
        line = cells.join(',');
    }
    writeBytes(folder + "/scan.csv", lines.join('\n'));
}

QJsonObject jsonOf(const QByteArray& text)
{
    return QJsonDocument::fromJson(text).object();
}

}  // namespace

void CliCalibrateTest::printsWhatItFinds()
{
    const QTemporaryDir folder;
    simulateHall(folder.path());

    const ProgramRun text = runProgram({"calibrate", "scan.csv"}, folder.path());
    const ProgramRun json = runProgram({"calibrate", "scan.csv", "--json"}, folder.path());

    QCOMPARE(text.code, 0);
    QCOMPARE(json.code, 0);
    QCOMPARE(text.err, QByteArray());
    const QJsonObject found = jsonOf(json.out);
    for (const char* quantity : {"pitch_zero", "range_offset", "lever_arm_correction", "sweep_turn", "pitch_delay"}) {
        QVERIFY2(text.out.contains(QByteArray("\n") + quantity), text.out);
        QVERIFY2(found.contains(quantity), json.out);
    }
    QVERIFY(std::abs(found["pitch_zero"]["value"].toDouble() - 2.0) < 0.1);
    QVERIFY(std::abs(found["range_offset"]["value"].toDouble()) < 0.001);
    QVERIFY(!found["pitch_delay"]["observed"].toBool());
    QVERIFY(found["pitch_delay"]["value"].isNull());
    QVERIFY(
        text.out.contains("not observable: the head nods one way, where a delay is a part of pitch_zero; scan "
                          "while the head nods both ways"));
    QVERIFY(text.out.contains("if the scanner stood level: 2 planes taken as level"));
}

void CliCalibrateTest::theSensorFileCorrectsExtraction()
{
    const QTemporaryDir folder;
    simulateHall(folder.path());
    const auto medianAngle = [&](const QString& planes) {
        const ProgramRun run =
            runProgram({"compare", planes, "truth.csv", "--angle", "6", "--distance", "0.5", "--json"}, folder.path());
        const QJsonObject facts = jsonOf(run.out);
        return facts["angle_error_deg"]["median"].toDouble();
    };

    const ProgramRun run = runProgram({"calibrate", "scan.csv", "-o", "mine.json"}, folder.path());
    for (const char* preset : {"paper", "precise"}) {
        runProgram({"extract", "scan.csv", "--preset", preset, "--planes", QString(preset) + ".before.csv"},
                   folder.path());
        runProgram({"extract", "scan.csv", "--preset", preset, "--sensor", "mine.json", "--planes",
                    QString(preset) + ".after.csv"},
                   folder.path());
    }

    QCOMPARE(run.code, 0);
    QVERIFY(bytesOf(folder.filePath("mine.json")).contains("\"noise.range-constant\":0.008"));
    QVERIFY(medianAngle("precise.before.csv") > 0.8);
    QVERIFY(medianAngle("precise.after.csv") < 0.1);
    QVERIFY(medianAngle("paper.after.csv") < 0.5 * medianAngle("paper.before.csv"));
}

void CliCalibrateTest::keepsASensorFileUnlessToldOtherwise()
{
    const QTemporaryDir folder;
    simulateHall(folder.path());
    writeBytes(folder.filePath("mine.json"), "precious");

    const ProgramRun kept = runProgram({"calibrate", "scan.csv", "-o", "mine.json"}, folder.path());
    const QByteArray before = bytesOf(folder.filePath("mine.json"));
    const ProgramRun replaced = runProgram({"calibrate", "scan.csv", "-o", "mine.json", "--overwrite"}, folder.path());

    QCOMPARE(kept.code, 5);
    QCOMPARE(before, QByteArray("precious"));
    QCOMPARE(replaced.code, 0);
    QVERIFY(bytesOf(folder.filePath("mine.json")).startsWith("{\"format\":\"planewright-preset 1\""));
}

void CliCalibrateTest::realRecordingsAreSaidToTellWhatTheyTell_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<bool>("stoodLevel");
    QTest::newRow("lobby") << "lobby.csv.gz" << true;
    QTest::newRow("desk") << "desk.csv.gz" << false;
}

void CliCalibrateTest::realRecordingsAreSaidToTellWhatTheyTell()
{
    QFETCH(QString, name);
    QFETCH(bool, stoodLevel);
    const QString recording = realRecording(name);
    QVERIFY(!recording.isEmpty());

    const ProgramRun run = runProgram({"calibrate", recording, "--json"});

    QCOMPARE(run.code, 0);
    const QJsonObject found = jsonOf(run.out);
    QCOMPARE(found["pitch_zero"]["observed"].toBool(), stoodLevel);
    QVERIFY(std::abs(found["pitch_zero"]["value"].toDouble()) < 3.0);
    // No scanner of this kind is off by more, and none of these scans tells more finely than a few millimetres.
    QVERIFY(std::abs(found["range_offset"]["value"].toDouble()) < 0.06);
    QVERIFY(std::abs(found["lever_arm_correction"]["value"].toDouble()) < 0.05);
    QVERIFY(!found["pitch_delay"]["observed"].toBool());
}

void CliCalibrateTest::withoutPlanesNothingIsWritten()
{
    const QTemporaryDir folder;
    writeBytes(folder.filePath("scan.csv"), recordingText(5, 9, 0));

    const ProgramRun run = runProgram({"calibrate", "scan.csv", "-o", "mine.json"}, folder.path());

    QCOMPARE(run.code, 8);
    QCOMPARE(run.err, QByteArray("planewright-cli: scan.csv: no plane is seen well enough to calibrate by; scan a room "
                                 "with its floor and walls, over as much pitch as the scanner can\n"));
    QVERIFY(bytesOf(folder.filePath("mine.json")).isNull());
}

void CliCalibrateTest::aScanThatTellsNothingIsNamed()
{
    const QTemporaryDir folder;
    simulateHall(folder.path());
    writeBytes(folder.filePath("sky.csv"), recordingText(5, 9, 0));

    const ProgramRun run = runProgram({"calibrate", "scan.csv", "sky.csv"}, folder.path());

    QCOMPARE(run.code, 0);
    QCOMPARE(run.err, QByteArray("planewright-cli: warning: sky.csv: no plane is seen well enough; this scan tells "
                                 "nothing\n"));
}

void CliCalibrateTest::wrongUseIsAnError_data()
{
    QTest::addColumn<QStringList>("options");
    QTest::addColumn<int>("code");
    QTest::addColumn<QString>("message");
    QTest::newRow("no input") << QStringList{} << 2 << "INPUT is required";
    QTest::newRow("no such file") << QStringList{"none.csv"} << 3 << "none.csv: there is no such file";
    QTest::newRow("no recording") << QStringList{"scan.bag"} << 2 << "scan.bag: the name of a recording";
    QTest::newRow("malformed") << QStringList{"broken.csv"} << 3 << "broken.csv: ";
    QTest::newRow("onto the input") << QStringList{"scan.csv", "-o", "scan.csv", "--overwrite"} << 2
                                    << "scan.csv: this is the input";
    QTest::newRow("level") << QStringList{"scan.csv", "--level", "maybe"} << 2 << "--level";
    QTest::newRow("no folder") << QStringList{"scan.csv", "-o", "none/mine.json"} << 5 << "none/mine.json: ";
    QTest::newRow("beyond the range") << QStringList{"scan.csv", "-P", "sensor.range-offset=2"} << 2
                                      << "-P: parameter sensor.range-offset: '2' is not allowed";
    QTest::newRow("another scanner")
        << QStringList{"scan.csv", "other.csv"} << 2
        << "other.csv: its scanner 'UST-20LX' is not the 'UTM-30LX' of scan.csv. Errors are "
           "those of one scanner: calibrate each with its own scans.";
}

void CliCalibrateTest::wrongUseIsAnError()
{
    QFETCH(QStringList, options);
    QFETCH(int, code);
    QFETCH(QString, message);
    const QTemporaryDir folder;
    writeBytes(folder.filePath("scan.csv"), recordingText(2, 3, 1500));
    writeBytes(folder.filePath("other.csv"), recordingText(2, 3, 1500, "UST-20LX"));
    writeBytes(folder.filePath("broken.csv"), "slice");

    const ProgramRun run = runProgram(QStringList{"calibrate"} + options, folder.path());

    QCOMPARE(run.code, code);
    QCOMPARE(run.err.count('\n'), 1);
    QVERIFY2(QString::fromUtf8(run.err).startsWith("planewright-cli: " + message), run.err);
}

void CliCalibrateTest::aDamagedRecordingIsUsedInPart()
{
    const QTemporaryDir folder;
    simulateHall(folder.path());
    const QByteArray whole = bytesOf(folder.filePath("scan.csv"));
    writeBytes(folder.filePath("scan.csv"), whole.left(whole.size() - 100));

    const ProgramRun run = runProgram({"calibrate", "scan.csv", "-o", "mine.json"}, folder.path());

    QCOMPARE(run.code, 4);
    QVERIFY(run.err.contains("the last row was cut short"));
    QVERIFY(!bytesOf(folder.filePath("mine.json")).isNull());
}

PLANEWRIGHT_TEST(CliCalibrateTest)
#include "cli_calibrate_test.moc"
