// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <csignal>
#include <sys/resource.h>

#include <QDir>
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

/// What the program says and leaves where devices, disks and shells are not as they should be, in real time.
class CliDeviceFaultsTest : public QObject {
    Q_OBJECT

private slots:
    void aScanThatLacksSlicesSaysSo();
    void aScanThatNeverBeganLeavesNothing();
    void whatEndsAScanIsSaidOnce();
    void whatIsWaitedForIsSaidOnceForEachSecond();
    void aFullDiskIsToldBesideADeviceThatIsLost();
    void aServerInTheBackgroundEndsWhenItIsInterrupted();
};

namespace {

constexpr int kWhole = 0;
constexpr int kLacking = 4;
constexpr int kNotWritten = 5;
constexpr int kWaitsForAPerson = 10;

int slicesIn(const QTemporaryDir& folder)
{
    const ProgramRun run = runProgram({"info", "room.pwscan", "--json"}, folder.path());
    return QJsonDocument::fromJson(run.out).array().at(0).toObject()["slices"].toInt();
}

}  // namespace

/// How many slices stay lost depends on how busy the machine is.
void CliDeviceFaultsTest::aScanThatLacksSlicesSaysSo()
{
    const QTemporaryDir folder;
    EmulatedRigProcess rig({"--laser", "tcp:0", "--tilt", "pty", "--fault", "laser-duplicate@20"});
    QVERIFY2(rig.isServing(), rig.error().constData());

    const ProgramRun run = runProgram({"record", "--scanner", rig.laser(), "--tilt-unit", rig.tiltUnit(), "--tilt",
                                       "70:110:1.16", "-o", "room.pwscan"},
                                      folder.path());

    const int missing = 34 - slicesIn(folder);
    QVERIFY2(run.code == (missing == 0 ? kWhole : kLacking), run.err.constData());
    const QByteArray said =
        missing == 1 ? QByteArray("1 slice of the plan is missing; the scan is marked as partial")
                     : QByteArray::number(missing) + " slices of the plan are missing; the scan is marked as partial";
    QCOMPARE(run.err.contains(said), missing > 0);
}

void CliDeviceFaultsTest::aScanThatNeverBeganLeavesNothing()
{
    const QTemporaryDir folder;
    EmulatedRigProcess rig({"--laser", "tcp:0", "--tilt", "tcp:0", "--fault", "servo-frozen"});
    QVERIFY2(rig.isServing(), rig.error().constData());
    const QStringList arguments{"record",       "--scanner", rig.laser(),  "--tilt-unit",
                                rig.tiltUnit(), "--tilt",    "40:60:1.16", "-o"};
    QCOMPARE(
        runProgram({"record", "--scanner", "sim:empty?speed=0", "--slices", "3", "-o", "mine.pwscan"}, folder.path())
            .code,
        kWhole);

    const ProgramRun fresh = runProgram(arguments + QStringList{"room.pwscan"}, folder.path());
    const ProgramRun appended = runProgram(arguments + QStringList{"mine.pwscan", "--append"}, folder.path());

    QVERIFY2(fresh.code == kWaitsForAPerson, fresh.err.constData());
    QVERIFY2(fresh.err.contains("room.pwscan: no slice has come; nothing is left of this scan"), fresh.err.constData());
    QVERIFY2(appended.code == kWaitsForAPerson, appended.err.constData());
    QCOMPARE(QDir(folder.path()).entryList(QDir::Files), QStringList{"mine.pwscan"});
    const ProgramRun scans = runProgram({"info", "mine.pwscan", "--json"}, folder.path());
    QCOMPARE(QJsonDocument::fromJson(scans.out).array().size(), 1);
}

void CliDeviceFaultsTest::whatEndsAScanIsSaidOnce()
{
    const QTemporaryDir folder;
    EmulatedRigProcess rig({"--laser", "tcp:0", "--tilt", "tcp:0", "--fault", "servo-overload@10"});
    QVERIFY2(rig.isServing(), rig.error().constData());

    const ProgramRun run = runProgram(
        {"record", "--scanner", rig.laser(), "--tilt-unit", rig.tiltUnit(), "-o", "room.pwscan"}, folder.path());

    QVERIFY2(run.code == kWaitsForAPerson, run.err.constData());
    QVERIFY2(run.err.count("(overload)") == 1, run.err.constData());
}

void CliDeviceFaultsTest::whatIsWaitedForIsSaidOnceForEachSecond()
{
    const QTemporaryDir folder;
    EmulatedRigProcess rig({"--laser", "tcp:0", "--tilt", "tcp:0", "--fault", "laser-boot"});
    QVERIFY2(rig.isServing(), rig.error().constData());

    const ProgramRun run = runProgram({"record", "--scanner", rig.laser(), "--tilt-unit", rig.tiltUnit(), "--tilt",
                                       "88:92:1.16", "--step-and-stare", "-o", "room.pwscan"},
                                      folder.path());

    QByteArrayList waited = run.err.split('\n');
    waited.removeIf([](const QByteArray& line) { return !line.contains("waiting for the laser to start"); });
    QVERIFY2(!waited.isEmpty(), run.err.constData());
    for (const QByteArray& line : waited)
        QVERIFY2(waited.count(line) == 1, line.constData());
}

/// Files of the program may not grow beyond 200 kB: that is less than the scan until the servo is pulled out, and less
/// than what the laser says.
void CliDeviceFaultsTest::aFullDiskIsToldBesideADeviceThatIsLost()
{
    const QTemporaryDir folder;
    EmulatedRigProcess rig({"--laser", "tcp:0", "--tilt", "tcp:0", "--fault", "servo-unplug@120"});
    QVERIFY2(rig.isServing(), rig.error().constData());
    QProcess process;
    process.setWorkingDirectory(folder.path());
    process.setChildProcessModifier([] {
        const rlimit limit{200'000, 200'000};
        ::setrlimit(RLIMIT_FSIZE, &limit);
    });

    process.start(PLANEWRIGHT_CLI, {"record", "--scanner", rig.laser(), "--tilt-unit", rig.tiltUnit(), "--retries", "0",
                                    "--dialogues", folder.filePath("dialogues"), "-o", "room.pwscan"});
    QVERIFY(process.waitForFinished(120'000));

    const QByteArray said = process.readAllStandardError();
    QVERIFY2(process.exitCode() == kNotWritten, said.constData());
    const QByteArrayList lines = said.trimmed().split('\n');
    QVERIFY2(QRegularExpression("; \\d+ slices? of this scan (is|are) not on the disk")
                 .match(QString::fromUtf8(lines.last()))
                 .hasMatch(),
             said.constData());
    const QByteArray lost = lines.at(lines.size() - 2);
    QVERIFY2(lost.contains("servo") || lost.contains("connection"), said.constData());
    QVERIFY2(said.contains("laser-1.dialogue: the dialogue is recorded no further"), said.constData());
}

/// A shell without job control has what it runs in the background ignore SIGINT.
void CliDeviceFaultsTest::aServerInTheBackgroundEndsWhenItIsInterrupted()
{
    QProcess process;
    process.setChildProcessModifier([] { ::signal(SIGINT, SIG_IGN); });
    process.start(PLANEWRIGHT_CLI, {"emulate", "--laser", "tcp:0"});
    QVERIFY(process.waitForReadyRead(60'000));

    ::kill(static_cast<pid_t>(process.processId()), SIGINT);
    QVERIFY(process.waitForFinished(60'000));

    QCOMPARE(process.exitStatus(), QProcess::NormalExit);
    QCOMPARE(process.exitCode(), 130);
}

PLANEWRIGHT_TEST(CliDeviceFaultsTest)
#include "cli_device_faults_test.moc"
