// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <csignal>
#include <random>
#include <sys/types.h>

#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include "core/formats/recording_pwscan.h"
#include "pwscan_sample.h"
#include "tests/test_program.h"

using namespace planewright;

/// A process that records, or edits, is killed at random moments: what it has acknowledged is there.
class PwscanKillTest : public QObject {
    Q_OBJECT

private slots:
    void everyAcknowledgedSliceIsThere();
    void everyEditIsWholeOrAbsent();

private:
    static int loops() { return qEnvironmentVariableIsSet("PLANEWRIGHT_TEST_LONG") ? 1000 : 10; }
    static QList<int> acknowledgedBeforeKill(const QStringList& arguments, int milliseconds);
    static void verifyNoProblem(const std::string& path);
};

QList<int> PwscanKillTest::acknowledgedBeforeKill(const QStringList& arguments, int milliseconds)
{
    QProcess process;
    process.start(RECORD_SLICES, arguments);
    if (!process.waitForReadyRead(60'000))
        qFatal("the helper says nothing: %s", process.readAllStandardError().constData());
    QTest::qSleep(milliseconds);
    ::kill(static_cast<pid_t>(process.processId()), SIGKILL);
    process.waitForFinished(-1);
    QList<int> numbers;
    for (const QByteArray& line : process.readAllStandardOutput().split('\n')) {
        if (!line.isEmpty())
            numbers << line.toInt();
    }
    return numbers;
}

void PwscanKillTest::verifyNoProblem(const std::string& path)
{
    const RecordingProblems found = pwscanProblems(path);

    QVERIFY2(found.problems.empty(), found.problems.empty() ? "" : found.problems.front().c_str());
    QVERIFY2(!found.damaged, found.warnings.empty() ? "" : found.warnings.front().c_str());
}

void PwscanKillTest::everyAcknowledgedSliceIsThere()
{
    std::mt19937 random(20'260'301);
    const QTemporaryDir folder;
    std::string path;
    for (int loop = 0; loop < loops(); ++loop) {
        // Every third loop adds to what the kill before has left.
        if (loop % 3 != 2)
            path = folder.filePath(QString("%1.pwscan").arg(loop)).toStdString();

        const QList<int> acknowledged =
            acknowledgedBeforeKill({"record", QString::fromStdString(path)}, static_cast<int>(random() % 120));

        const auto read = readRecordingPwscan(path);
        QVERIFY2(read, read ? "" : read.error().message.c_str());
        QVERIFY(!read->read.damaged);
        const std::vector<ScanSlice>& slices = read->read.recording.slices;
        QVERIFY(!acknowledged.isEmpty());
        QVERIFY(slices.size() >= static_cast<std::size_t>(acknowledged.size()));
        const Recording expected = sampleRecording(static_cast<int>(slices.size()), 721);
        for (std::size_t i = 0; i < slices.size(); ++i) {
            QCOMPARE(slices[i].step, static_cast<int>(i));
            QVERIFY(slices[i].ranges == expected.slices[i].ranges);
        }
        verifyNoProblem(path);
    }
}

void PwscanKillTest::everyEditIsWholeOrAbsent()
{
    std::mt19937 random(20'260'302);
    const QTemporaryDir folder;
    const std::string path = folder.filePath("a.pwscan").toStdString();
    const QString name = QString::fromStdString(path);
    acknowledgedBeforeKill({"record", name}, 10);
    for (int loop = 0; loop < loops() / 2; ++loop) {
        const QList<int> acknowledged = acknowledgedBeforeKill({"edit", name}, static_cast<int>(random() % 60));

        const auto read = readRecordingPwscan(path);
        QVERIFY2(read, read ? "" : read.error().message.c_str());
        QVERIFY(!read->read.damaged);
        const std::vector<StoredEdit>& edits = read->notes.edits;
        QVERIFY(!acknowledged.isEmpty());
        QVERIFY(edits.size() >= static_cast<std::size_t>(acknowledged.last()));
        for (const StoredEdit& edit : edits) {
            QCOMPARE(edit.edit.text, std::string(100, 'n'));
            if (acknowledged.contains(edit.seq))
                QCOMPARE(edit.undone, edit.seq % 3 == 0);
        }
        verifyNoProblem(path);
    }
}

PLANEWRIGHT_TEST(PwscanKillTest)
#include "pwscan_kill_test.moc"
