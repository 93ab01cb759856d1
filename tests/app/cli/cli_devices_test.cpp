// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <csignal>

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QtTest>

#include "run_program.h"
#include "tests/app/emulated_rig_process.h"
#include "tests/test_program.h"

/// Scanning with devices that another process emulates, in real time.
class CliDevicesTest : public QObject {
    Q_OBJECT

private slots:
    void aScanIsRecordedOverLinks_data();
    void aScanIsRecordedOverLinks();
    void aKilledProgramLeavesAScanAndDevicesThatConnectAgain();
    void everyByteOfADialogueIsRecorded();
    void aDeviceThatIsNotThereIsSaid_data();
    void aDeviceThatIsNotThereIsSaid();
    void whatIsWrongIsSaidBeforeAnythingIsOpened_data();
    void whatIsWrongIsSaidBeforeAnythingIsOpened();
    void aDeviceThatIsLostEndsTheScanWithWhatThereIs();
    void whatIsConnectedIsListed();
    void everyServoThatIsEmulatedScans_data();
    void everyServoThatIsEmulatedScans();
    void whatCannotBeEmulatedIsSaid_data();
    void whatCannotBeEmulatedIsSaid();
    void theHeadGoesToLevel();
    void aScanBeginsAtLevelWhereThatIsAskedFor_data();
    void aScanBeginsAtLevelWhereThatIsAskedFor();
    void anInterruptHoldsAHeadOnItsWay();
    void aUnitThatTurnedItselfOffIsReleasedByAPersonOnly();
    void theRigsLimitsAndLeverArmAreThoseOfTheScan();

private:
    static QJsonObject infoOf(const QString& folder);
};

namespace {

constexpr int kDone = 0;
constexpr int kPartial = 4;
constexpr int kNeedsOperator = 10;

/// On a busy machine some slices of a sweep stay lost.
bool isRecorded(const ProgramRun& run)
{
    return run.code == kDone || run.code == kPartial;
}

}  // namespace

/// What the program says of room.pwscan.
QJsonObject CliDevicesTest::infoOf(const QString& folder)
{
    const ProgramRun run = runProgram({"info", "room.pwscan", "--json"}, folder);
    const QJsonDocument document = QJsonDocument::fromJson(run.out);
    return document.array().at(0).toObject();
}

void CliDevicesTest::aScanIsRecordedOverLinks_data()
{
    QTest::addColumn<QStringList>("served");
    QTest::addColumn<QStringList>("options");
    QTest::newRow("servo on a line") << QStringList{"--laser", "tcp:0", "--tilt", "pty"} << QStringList{};
    QTest::newRow("servo on a line, stepping")
        << QStringList{"--laser", "pty", "--tilt", "pty"} << QStringList{"--step-and-stare"};
    QTest::newRow("board on a line") << QStringList{"--laser", "tcp:0", "--board", "pty"} << QStringList{};
}

void CliDevicesTest::aScanIsRecordedOverLinks()
{
    QFETCH(QStringList, served);
    QFETCH(QStringList, options);
    const QTemporaryDir folder;
    EmulatedRigProcess rig(served);
    QVERIFY2(rig.isServing(), rig.error().constData());

    const ProgramRun run = runProgram(QStringList{"record", "--scanner", rig.laser(), "--tilt-unit", rig.tiltUnit(),
                                                  "--tilt", "70:110:1.16", "--retries", "5", "-o", "room.pwscan"} +
                                          options,
                                      folder.path());

    const QJsonObject info = infoOf(folder.path());
    // A busy machine answers too late for some slices; those that stay lost make the scan a partial one.
    const int slices = info["slices"].toInt();
    QVERIFY2(slices >= 25, (QByteArray::number(slices) + " " + run.err).constData());
    QVERIFY2(run.code == (slices == 34 ? kDone : kPartial), run.err.constData());
    QCOMPARE(info["state"].toString(), QString(slices == 34 ? "complete" : "partial"));
    QCOMPARE(info["planned_slices"].toInt(), 34);
    QVERIFY(std::abs(info["pitch_first_deg"].toDouble() - 70.0) < 2.5);
    QVERIFY(info["scanner"].toString().contains("UTM-30LX"));
    QCOMPARE(info["continuous"].toBool(), options.isEmpty());

    // Its large planes are those of the simulator fed directly: half a count of the servo is 0.15 degrees.
    QCOMPARE(
        runProgram({"simulate", "corridor", "--seed", "7", "--tilt", "70:110:1.16", "-o", "made.csv"}, folder.path())
            .code,
        0);
    for (const char* scan : {"room.pwscan", "made.csv"}) {
        const QString planes = QString(scan).replace(QLatin1Char('.'), QLatin1Char('-')) + ".csv";
        QCOMPARE(runProgram({"extract", scan, "--planes", planes}, folder.path()).code, 0);
    }
    const ProgramRun compared = runProgram({"compare", "room-pwscan.csv", "made-csv.csv", "--angle", "0.15",
                                            "--distance", "0.01", "--min-returns", "2000", "--fail-above", "0"},
                                           folder.path());
    QVERIFY2(compared.code == 0, (compared.out + compared.err).constData());
    QVERIFY2(compared.out.contains("matched"), compared.out.constData());
    QVERIFY(!compared.out.contains("matched                 0\n"));
}

void CliDevicesTest::aKilledProgramLeavesAScanAndDevicesThatConnectAgain()
{
    const QTemporaryDir folder;
    EmulatedRigProcess rig({"--laser", "tcp:0", "--tilt", "pty"});
    QVERIFY2(rig.isServing(), rig.error().constData());
    const QStringList arguments{"record", "--scanner", rig.laser(), "--tilt-unit", rig.tiltUnit(), "-o"};
    QProcess first;
    first.setWorkingDirectory(folder.path());
    first.start(PLANEWRIGHT_CLI, arguments + QStringList{"first.pwscan"});
    // Its recording grows as soon as the head moves.
    const auto size = [&] { return QFileInfo(folder.filePath("first.pwscan-wal")).size(); };
    QTRY_VERIFY_WITH_TIMEOUT(size() > 100'000, 60'000);

    ::kill(static_cast<pid_t>(first.processId()), SIGKILL);
    QVERIFY(first.waitForFinished());
    const ProgramRun second =
        runProgram(arguments + QStringList{"room.pwscan", "--tilt", "80:100:1.16", "--retries", "5"}, folder.path());

    QVERIFY2(isRecorded(second), second.err.constData());
    QCOMPARE(runProgram({"validate", "first.pwscan"}, folder.path()).code, 0);
    QVERIFY(infoOf(folder.path())["slices"].toInt() >= 12);
}

void CliDevicesTest::everyByteOfADialogueIsRecorded()
{
    const QTemporaryDir folder;
    EmulatedRigProcess rig({"--laser", "tcp:0", "--tilt", "pty"});
    QVERIFY2(rig.isServing(), rig.error().constData());

    const ProgramRun run = runProgram({"record", "--scanner", rig.laser(), "--tilt-unit", rig.tiltUnit(), "--tilt",
                                       "85:95:1.16", "--dialogues", folder.path(), "-o", "room.pwscan"},
                                      folder.path());

    QVERIFY2(isRecorded(run), run.err.constData());
    const QByteArray laser = bytesOf(folder.filePath("laser-1.dialogue"));
    QVERIFY(laser.contains("MD0180090000000"));
    QVERIFY(laser.size() > 8 * 2258);
    QVERIFY(!bytesOf(folder.filePath("tilt-1.dialogue")).isEmpty());
}

void CliDevicesTest::aDeviceThatIsNotThereIsSaid_data()
{
    QTest::addColumn<QString>("laser");
    QTest::addColumn<QByteArray>("said");
    QTest::newRow("port that refuses") << "tcp:127.0.0.1:1" << QByteArray("127.0.0.1:1");
    QTest::newRow("no such port") << "serial:/dev/no-such-port" << QByteArray("/dev/no-such-port");
    QTest::newRow("no such number") << "usb:NoSuchNumber" << QByteArray("connected by USB");
}

void CliDevicesTest::aDeviceThatIsNotThereIsSaid()
{
    QFETCH(QString, laser);
    QFETCH(QByteArray, said);
    const QTemporaryDir folder;

    const ProgramRun run =
        runProgram({"record", "--scanner", laser, "--tilt-unit", "dynamixel:usb:", "-o", "room.pwscan"}, folder.path());

    QCOMPARE(run.code, 6);
    QVERIFY2(run.err.contains(said), run.err.constData());
    QCOMPARE(run.err.count('\n'), 1);
    QVERIFY(!QFile::exists(folder.filePath("room.pwscan")));
}

void CliDevicesTest::whatIsWrongIsSaidBeforeAnythingIsOpened_data()
{
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<QByteArray>("said");
    QTest::newRow("no tilt unit") << QStringList{"--scanner", "usb:"} << QByteArray("--tilt-unit");
    QTest::newRow("tilt unit of a simulation")
        << QStringList{"--scanner", "sim:hall", "--tilt-unit", "board:usb:"} << QByteArray("leave them out");
    QTest::newRow("no tilt unit's address")
        << QStringList{"--scanner", "usb:", "--tilt-unit", "usb:"} << QByteArray("dynamixel: or board:");
    QTest::newRow("no angle") << QStringList{"--scanner", "usb:", "--tilt-unit", "board:usb:", "--bearing", "0-180"}
                              << QByteArray("--bearing: '0-180'");
}

void CliDevicesTest::whatIsWrongIsSaidBeforeAnythingIsOpened()
{
    QFETCH(QStringList, arguments);
    QFETCH(QByteArray, said);
    const QTemporaryDir folder;

    const ProgramRun run = runProgram(QStringList{"record", "-o", "room.pwscan"} + arguments, folder.path());

    QVERIFY2(run.code == 2 || run.code == 6, run.err.constData());
    QVERIFY2(run.err.contains(said), run.err.constData());
}

void CliDevicesTest::aDeviceThatIsLostEndsTheScanWithWhatThereIs()
{
    const QTemporaryDir folder;
    EmulatedRigProcess rig({"--laser", "tcp:0", "--tilt", "pty", "--fault", "servo-unplug@60"});
    QVERIFY2(rig.isServing(), rig.error().constData());

    const ProgramRun run = runProgram(
        {"record", "--scanner", rig.laser(), "--tilt-unit", rig.tiltUnit(), "-o", "room.pwscan"}, folder.path());

    QCOMPARE(run.code, 7);
    QCOMPARE(infoOf(folder.path())["state"].toString(), QString("fault"));
    QVERIFY(infoOf(folder.path())["slices"].toInt() > 0);
    QCOMPARE(runProgram({"validate", "room.pwscan"}, folder.path()).code, 0);
}

void CliDevicesTest::whatIsConnectedIsListed()
{
    const ProgramRun text = runProgram({"devices"});
    const ProgramRun json = runProgram({"devices", "--json"});

    QCOMPARE(text.code, 0);
    QVERIFY(!text.out.isEmpty());
    QCOMPARE(json.code, 0);
    QVERIFY(QJsonDocument::fromJson(json.out).isArray());
}

void CliDevicesTest::everyServoThatIsEmulatedScans_data()
{
    QTest::addColumn<QString>("servo");
    QTest::addColumn<QString>("baud");
    QTest::newRow("AX-12") << "AX-12"
                           << "1000000";
    QTest::newRow("MX-28") << "MX-28"
                           << "57142";
    QTest::newRow("of protocol 2.0") << "XM430-W350"
                                     << "57600";
}

void CliDevicesTest::everyServoThatIsEmulatedScans()
{
    QFETCH(QString, servo);
    QFETCH(QString, baud);
    const QTemporaryDir folder;
    EmulatedRigProcess rig({"--laser", "tcp:0", "--tilt", "pty", "--servo", servo, "--baud", baud});
    QVERIFY2(rig.isServing(), rig.error().constData());
    QVERIFY2(rig.tiltUnit().endsWith("?baud=" + baud), qPrintable(rig.tiltUnit()));

    const ProgramRun run = runProgram({"record", "--scanner", rig.laser(), "--tilt-unit", rig.tiltUnit(), "--tilt",
                                       "85:95:2", "--step-and-stare", "--retries", "5", "-o", "room.pwscan"},
                                      folder.path());

    QVERIFY2(run.code == 0, run.err.constData());
    QCOMPARE(infoOf(folder.path())["slices"].toInt(), 5);
    QVERIFY(bytesOf(folder.filePath("room.pwscan")).contains(servo.toUtf8()));
}

void CliDevicesTest::whatCannotBeEmulatedIsSaid_data()
{
    QTest::addColumn<QStringList>("options");
    QTest::addColumn<QByteArray>("said");
    QTest::newRow("no servo") << QStringList{"--laser", "tcp:0", "--servo", "AX-12"} << QByteArray("without --tilt");
    QTest::newRow("unknown servo") << QStringList{"--tilt", "pty", "--servo", "AX-18"}
                                   << QByteArray("Known: RX-64, AX-12, MX-28 and XM430-W350");
    QTest::newRow("no rate") << QStringList{"--tilt", "pty", "--baud", "9"} << QByteArray("--baud");
}

void CliDevicesTest::whatCannotBeEmulatedIsSaid()
{
    QFETCH(QStringList, options);
    QFETCH(QByteArray, said);

    const ProgramRun run = runProgram(QStringList{"emulate"} + options);

    QCOMPARE(run.code, 2);
    QVERIFY2(run.err.contains(said), run.err.constData());
}

void CliDevicesTest::theHeadGoesToLevel()
{
    EmulatedRigProcess rig({"--laser", "tcp:0", "--tilt", "pty"});
    QVERIFY2(rig.isServing(), rig.error().constData());

    // Its middle is said to look to 70°: level is 20° away.
    const ProgramRun run = runProgram({"devices", "--home", rig.tiltUnit() + "?zero=70"});
    const ProgramRun laser = runProgram({"devices", "--home", rig.laser()});

    QVERIFY2(run.code == 0, run.err.constData());
    QVERIFY2(QRegularExpression("^RX-64.* is held at (89\\.[5-9]|90|90\\.[1-5])°\n$")
                 .match(QString::fromUtf8(run.out))
                 .hasMatch(),
             run.out.constData());
    QCOMPARE(laser.code, 2);
    QVERIFY2(laser.err.contains("dynamixel: or board:"), laser.err.constData());
}

void CliDevicesTest::aScanBeginsAtLevelWhereThatIsAskedFor_data()
{
    QTest::addColumn<QString>("tilt");
    QTest::newRow("servo") << "--tilt";
    QTest::newRow("board") << "--board";
}

void CliDevicesTest::aScanBeginsAtLevelWhereThatIsAskedFor()
{
    QFETCH(QString, tilt);
    const QTemporaryDir folder;
    EmulatedRigProcess rig({"--laser", "tcp:0", tilt, "pty"});
    QVERIFY2(rig.isServing(), rig.error().constData());

    // Its middle is said to look to 80°: level is 10° away.
    const ProgramRun run =
        runProgram({"record", "--home", "--scanner", rig.laser(), "--tilt-unit", rig.tiltUnit() + "?zero=80", "--tilt",
                    "80:90:1", "--retries", "5", "-o", "room.pwscan"},
                   folder.path());
    const ProgramRun simulated =
        runProgram({"record", "--home", "--scanner", "sim:corridor", "-o", "sim.pwscan"}, folder.path());

    QVERIFY2(isRecorded(run), run.err.constData());
    QVERIFY2(run.err.contains("the head is at 90") || run.err.contains("the head is at 89."), run.err.constData());
    QVERIFY(infoOf(folder.path())["slices"].toInt() >= 5);
    QCOMPARE(simulated.code, 2);
    QVERIFY2(simulated.err.contains("--home"), simulated.err.constData());
    QVERIFY(!QFileInfo::exists(folder.filePath("sim.pwscan")));
}

void CliDevicesTest::anInterruptHoldsAHeadOnItsWay()
{
    EmulatedRigProcess rig({"--laser", "tcp:0", "--tilt", "pty"});
    QVERIFY2(rig.isServing(), rig.error().constData());
    const QTemporaryDir folder;
    // 80° at 20° a second take four seconds.
    QProcess moving;
    moving.start(PLANEWRIGHT_CLI, {"devices", "--home", rig.tiltUnit() + "?zero=10"});
    QVERIFY(moving.waitForStarted());
    QTest::qWait(1500);

    ::kill(static_cast<pid_t>(moving.processId()), SIGINT);
    QVERIFY(moving.waitForFinished(60'000));

    QCOMPARE(moving.exitCode(), 130);
    QVERIFY2(moving.readAllStandardError().contains("stopped"), "it does not say what has become of the motion");
    // What it does from there on takes as long as the rest of the way.
    const ProgramRun rest = runProgram({"devices", "--home", rig.tiltUnit() + "?zero=10"});
    QVERIFY2(rest.code == 0, rest.err.constData());
}

void CliDevicesTest::aUnitThatTurnedItselfOffIsReleasedByAPersonOnly()
{
    const QTemporaryDir folder;
    EmulatedRigProcess rig({"--laser", "tcp:0", "--tilt", "pty", "--fault", "servo-overload@5"});
    QVERIFY2(rig.isServing(), rig.error().constData());

    const ProgramRun scan = runProgram({"record", "--scanner", rig.laser(), "--tilt-unit", rig.tiltUnit(), "--tilt",
                                        "80:100:1", "-o", "room.pwscan", "--retries", "3"},
                                       folder.path());
    const ProgramRun refused = runProgram({"devices", "--home", rig.tiltUnit()});
    const ProgramRun released = runProgram({"devices", "--recover", rig.tiltUnit()});
    const ProgramRun home = runProgram({"devices", "--home", rig.tiltUnit()});

    QVERIFY2(scan.code == kNeedsOperator, scan.err.constData());
    QVERIFY2(scan.err.contains("overload"), scan.err.constData());
    QVERIFY2(refused.code == kNeedsOperator, refused.err.constData());
    QVERIFY2(released.code == 0, released.err.constData());
    QVERIFY2(home.code == 0, home.err.constData());
}

void CliDevicesTest::theRigsLimitsAndLeverArmAreThoseOfTheScan()
{
    const QTemporaryDir folder;
    EmulatedRigProcess rig({"--laser", "tcp:0", "--tilt", "pty"});
    QVERIFY2(rig.isServing(), rig.error().constData());
    const QStringList arguments{"record",           "--scanner", rig.laser(), "--tilt",         "85:95:2",
                                "--step-and-stare", "--settle",  "20",        "--travel-speed", "45",
                                "--axis-offset",    "0.0815",    "-o",        "room.pwscan",    "--tilt-unit"};

    const ProgramRun limited =
        runProgram(arguments + QStringList{rig.tiltUnit() + "?lowest=88&highest=100"}, folder.path());
    const ProgramRun run = runProgram(arguments + QStringList{rig.tiltUnit() + "?lowest=80&fastest=60"}, folder.path());

    QCOMPARE(limited.code, 2);
    QVERIFY2(limited.err.contains("may go from 88° to 100°"), limited.err.constData());
    QVERIFY2(run.code == 0, run.err.constData());
    QCOMPARE(infoOf(folder.path())["pitch_axis_offset_m"].toDouble(), 0.0815);
}

PLANEWRIGHT_TEST(CliDevicesTest)
#include "cli_devices_test.moc"
