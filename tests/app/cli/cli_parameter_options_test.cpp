// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <QDir>
#include <QJsonDocument>
#include <QTemporaryDir>
#include <QTest>

#include "run_program.h"
#include "tests/test_program.h"

namespace {

QByteArray presetText(const QByteArray& parameters)
{
    return R"({"format":"planewright-preset 1","parameters":{)" + parameters + "}}";
}

}  // namespace

/// Preset, then sensor, then each -P: the later wins.
class CliParameterOptionsTest : public QObject {
    Q_OBJECT

private slots:
    void laterSettingsWin();
    void sensorComesFromTheRecordingsScanner();
    void unknownScannerWarns();
    void presetMayBeAFileOrOneOfTheUsersOwn();
    void userWithoutAHomeHasNoPresets();
    void wrongValuesNameWhatIsAllowed_data();
    void wrongValuesNameWhatIsAllowed();

private:
    /// The value of noise.pitch [deg] that a run has in force, by the planes JSON it writes.
    static double pitchInForce(const QString& folder, const QStringList& options,
                               const QMap<QString, QString>& environment = {})
    {
        runProgram(QStringList{"extract", "scan.csv", "--planes", "p.json", "--overwrite"} + options, folder,
                   environment);
        return QJsonDocument::fromJson(bytesOf(folder + "/p.json"))["parameters"]["noise.pitch"].toDouble();
    }
};

void CliParameterOptionsTest::laterSettingsWin()
{
    const QTemporaryDir folder;
    writeBytes(folder.filePath("scan.csv"), recordingText(2, 3, 1500));
    writeBytes(folder.filePath("mine.json"), presetText(R"("noise.pitch":0.3)"));

    QCOMPARE(pitchInForce(folder.path(), {}), 0.084);
    QCOMPARE(pitchInForce(folder.path(), {"--sensor", "sick-lms200"}), 0.1);
    QCOMPARE(pitchInForce(folder.path(), {"--sensor", "mine.json"}), 0.3);
    QCOMPARE(pitchInForce(folder.path(), {"--preset", "mine.json", "--sensor", "sick-lms200"}), 0.1);
    QCOMPARE(pitchInForce(folder.path(), {"-P", "noise.pitch=0.4", "--sensor", "mine.json", "-P", "noise.pitch=0.5"}),
             0.5);
}

void CliParameterOptionsTest::sensorComesFromTheRecordingsScanner()
{
    const QTemporaryDir folder;
    writeBytes(folder.filePath("scan.csv"), recordingText(2, 3, 1500, "SICK LMS"));

    QCOMPARE(pitchInForce(folder.path(), {}), 0.1);
}

void CliParameterOptionsTest::unknownScannerWarns()
{
    const QTemporaryDir folder;
    writeBytes(folder.filePath("scan.csv"), recordingText(2, 3, 1500, "Acme 3000"));

    const ProgramRun warned = runProgram({"extract", "scan.csv"}, folder.path());
    const ProgramRun told = runProgram({"extract", "scan.csv", "--sensor", "utm-30lx"}, folder.path());

    QCOMPARE(warned.code, 0);
    QVERIFY2(warned.err.startsWith("planewright-cli: warning: the recording's scanner 'Acme 3000' is not known"),
             warned.err);
    QCOMPARE(told.err, QByteArray());
}

void CliParameterOptionsTest::presetMayBeAFileOrOneOfTheUsersOwn()
{
    const QTemporaryDir folder;
    QVERIFY(QDir(folder.path()).mkpath("config/planewright/presets"));
    writeBytes(folder.filePath("config/planewright/presets/attic.json"), presetText(R"("noise.pitch":0.7)"));
    writeBytes(folder.filePath("scan.csv"), recordingText(2, 3, 1500, ""));
    const QMap<QString, QString> environment{{"XDG_CONFIG_HOME", folder.filePath("config")}};

    QCOMPARE(pitchInForce(folder.path(), {"--preset", "attic"}, environment), 0.7);
    QCOMPARE(pitchInForce(folder.path(), {"--preset", "config/planewright/presets/attic.json"}), 0.7);
}

void CliParameterOptionsTest::userWithoutAHomeHasNoPresets()
{
    const QTemporaryDir folder;
    QVERIFY(QDir(folder.path()).mkpath("here/.config/planewright/presets"));
    writeBytes(folder.filePath("here/.config/planewright/presets/attic.json"), presetText(R"("noise.pitch":0.7)"));

    const ProgramRun run = runProgram({"params", "--preset", "attic"}, folder.path(),
                                      {{"XDG_CONFIG_HOME", "here/.config"}, {"HOME", "here"}});

    QCOMPARE(run.code, 2);
    QVERIFY2(run.err.contains("'attic' is neither a known name"), run.err);
}

void CliParameterOptionsTest::wrongValuesNameWhatIsAllowed_data()
{
    QTest::addColumn<QStringList>("options");
    QTest::addColumn<int>("code");
    QTest::addColumn<QString>("message");
    QTest::newRow("preset") << QStringList{"--preset", "none"} << 2
                            << "--preset: 'none' is neither a known name (precise, paper) nor a file";
    QTest::newRow("sensor") << QStringList{"--sensor", "none"} << 2
                            << "--sensor: 'none' is neither a known name (utm-30lx, ust-20lx, urg-04lx, sick-lms200, "
                               "depth-camera) nor a file";
    QTest::newRow("key") << QStringList{"-P", "segments.min-lenght=1"} << 2
                         << "-P: there is no parameter 'segments.min-lenght'; did you mean segments.min-length? "
                            "'planewright-cli params' lists all";
    QTest::newRow("value") << QStringList{"-P", "segments.min-length=-1"} << 2
                           << "-P: parameter segments.min-length: '-1' is not allowed; give a number from 0 to 10 m";
    QTest::newRow("comma") << QStringList{"-P", "segments.min-length=0,2"} << 2
                           << "-P: parameter segments.min-length: '0,2' is not allowed; give a number from 0 to 10 m";
    QTest::newRow("no equals") << QStringList{"-P", "x"} << 2 << "-P: parameter 'x': write key=value";
    QTest::newRow("broken preset") << QStringList{"--preset", "broken.json"} << 3 << "broken.json";
}

void CliParameterOptionsTest::wrongValuesNameWhatIsAllowed()
{
    QFETCH(QStringList, options);
    QFETCH(int, code);
    QFETCH(QString, message);
    const QTemporaryDir folder;
    writeBytes(folder.filePath("scan.csv"), recordingText(2, 3, 1500));
    writeBytes(folder.filePath("broken.json"), "{");

    const ProgramRun run = runProgram(QStringList{"extract", "scan.csv"} + options, folder.path());

    QCOMPARE(run.code, code);
    QCOMPARE(run.err.count('\n'), 1);
    QVERIFY2(QString::fromUtf8(run.err).startsWith("planewright-cli: " + message), run.err);
}

PLANEWRIGHT_TEST(CliParameterOptionsTest)
#include "cli_parameter_options_test.moc"
