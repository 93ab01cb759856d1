// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <csignal>

#include <QDir>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include "run_program.h"
#include "tests/test_program.h"

class CliInterruptionTest : public QObject {
    Q_OBJECT

private slots:
    void leavesNothingBehind_data();
    void leavesNothingBehind();
    void keepsTheOldFile();

private:
    static QStringList filesIn(const QString& folder)
    {
        return QDir(folder).entryList(QDir::Files | QDir::Hidden, QDir::Name);
    }
    /// Starts work that takes far longer than this test, waits until it has begun to write, and sends a signal.
    static int interrupt(const QString& folder, const QStringList& options, int signal);
};

int CliInterruptionTest::interrupt(const QString& folder, const QStringList& options, int signal)
{
    const qsizetype before = filesIn(folder).size();
    QProcess process;
    process.setWorkingDirectory(folder);
    process.start(PLANEWRIGHT_CLI, QStringList{"simulate", "office", "-o", "scan.csv", "--truth", "truth.csv", "--tilt",
                                               "10:170:0.01", "--bearing", "0:180:0.025"} +
                                       options);
    while (filesIn(folder).size() == before && process.state() != QProcess::NotRunning)
        process.waitForFinished(10);
    ::kill(static_cast<pid_t>(process.processId()), signal);
    process.waitForFinished(-1);
    return process.exitStatus() == QProcess::NormalExit ? process.exitCode() : -1;
}

void CliInterruptionTest::leavesNothingBehind_data()
{
    QTest::addColumn<int>("signal");
    QTest::addColumn<int>("code");
    QTest::newRow("SIGINT") << SIGINT << 130;
    QTest::newRow("SIGTERM") << SIGTERM << 143;
}

void CliInterruptionTest::leavesNothingBehind()
{
    QFETCH(int, signal);
    QFETCH(int, code);
    const QTemporaryDir folder;

    const int exitCode = interrupt(folder.path(), {}, signal);

    QCOMPARE(exitCode, code);
    QCOMPARE(filesIn(folder.path()), QStringList{});
}

void CliInterruptionTest::keepsTheOldFile()
{
    const QTemporaryDir folder;
    writeBytes(folder.filePath("scan.csv"), "old");

    const int exitCode = interrupt(folder.path(), {"--overwrite"}, SIGTERM);

    QCOMPARE(exitCode, 143);
    QCOMPARE(filesIn(folder.path()), QStringList{"scan.csv"});
    QCOMPARE(bytesOf(folder.filePath("scan.csv")), QByteArray("old"));
}

PLANEWRIGHT_TEST(CliInterruptionTest)
#include "cli_interruption_test.moc"
