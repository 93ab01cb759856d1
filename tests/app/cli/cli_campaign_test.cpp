// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include "run_program.h"
#include "tests/test_program.h"

/// Many scans, as the manual tells it.
class CliCampaignTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void parallelDoesThemAllAndOnlyOnce();
    void whatWasBrokenOffIsDoneWhenItIsStartedAgain();
    void tasksOfAnArrayShareTheList();
    void aScanThatCannotBeReadEndsNoOther();

private:
    QString path(const QString& name) const { return folder_.filePath(name); }
    int runIn(const QString& program, const QStringList& arguments, const QMap<QString, QString>& more = {}) const;
    QStringList done(const QString& into) const { return QDir(path(into)).entryList({"*"}, QDir::Files, QDir::Name); }

    QTemporaryDir folder_;
};

int CliCampaignTest::runIn(const QString& program, const QStringList& arguments,
                           const QMap<QString, QString>& more) const
{
    QProcess process;
    process.setWorkingDirectory(folder_.path());
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert("PLANEWRIGHT_CLI", PLANEWRIGHT_CLI);
    for (auto it = more.cbegin(); it != more.cend(); ++it)
        environment.insert(it.key(), it.value());
    process.setProcessEnvironment(environment);
    process.setStandardInputFile(QProcess::nullDevice());
    process.start(program, arguments);
    if (!process.waitForFinished(120'000))
        return -1;
    return process.exitStatus() == QProcess::NormalExit ? process.exitCode() : -1;
}

void CliCampaignTest::initTestCase()
{
    QVERIFY(QDir(folder_.path()).mkpath("scans"));
    QByteArray list;
    for (int i = 1; i <= 5; ++i) {
        const QString scan = QString("scans/s%1.csv.gz").arg(i);
        QCOMPARE(runProgram({"simulate", "office", "--seed", QString::number(i), "--tilt", "40:120:2", "-o", scan},
                            folder_.path())
                     .code,
                 0);
        list += path(scan).toUtf8() + '\n';
    }
    writeBytes(path("scans.txt"), list);
}

void CliCampaignTest::parallelDoesThemAllAndOnlyOnce()
{
    QVERIFY(QDir(folder_.path()).mkpath("planes"));
    const QStringList command{
        "-c",
        "parallel --will-cite -j 2 --joblog campaign.log \"$PLANEWRIGHT_CLI\" extract {} "
        "-P likelihood.chance-planes=200 --planes planes/{/.}.json --skip-existing ::: scans/*.csv.gz"};
    QCOMPARE(runIn("bash", command), 0);
    QCOMPARE(done("planes").size(), 5);
    const QByteArray first = bytesOf(path("planes/s1.csv.json"));

    QVERIFY(QFile::remove(path("planes/s3.csv.json")));
    writeBytes(path("planes/s2.csv.json"), "kept");
    QCOMPARE(runIn("bash", command), 0);

    QCOMPARE(done("planes").size(), 5);
    QCOMPARE(bytesOf(path("planes/s1.csv.json")), first);
    QCOMPARE(bytesOf(path("planes/s2.csv.json")), QByteArray("kept"));
    QVERIFY(bytesOf(path("planes/s3.csv.json")).startsWith("{\"format\":\"planewright-planes 1\""));
}

/// Killed at once or a little later, a run leaves whole results or none.
void CliCampaignTest::whatWasBrokenOffIsDoneWhenItIsStartedAgain()
{
    const QStringList extract{"extract",  "scans/s1.csv.gz", "--planes",       "k.json",
                              "--labels", "k.labels",        "--skip-existing"};
    QCOMPARE(runProgram(QStringList(extract).replaceInStrings("k.", "whole."), folder_.path()).code, 0);
    for (int milliseconds = 0; milliseconds < 60; milliseconds += 6) {
        QProcess process;
        process.setWorkingDirectory(folder_.path());
        process.start(PLANEWRIGHT_CLI, extract);
        QVERIFY(process.waitForStarted());
        QTest::qSleep(milliseconds);
        process.kill();
        QVERIFY(process.waitForFinished());

        QCOMPARE(runProgram(extract, folder_.path()).code, 0);

        QCOMPARE(bytesOf(path("k.json")), bytesOf(path("whole.json")));
        QCOMPARE(bytesOf(path("k.labels")), bytesOf(path("whole.labels")));
        QFile::remove(path("k.json"));
        QFile::remove(path("k.labels"));
    }
}

void CliCampaignTest::tasksOfAnArrayShareTheList()
{
    const QString script = QStringLiteral(PLANEWRIGHT_SOURCE_DIR "/resources/campaign/extract.sbatch");
    const auto task = [&](int number) {
        return runIn(script, {"scans.txt", "array"},
                     {{"SLURM_ARRAY_TASK_ID", QString::number(10 + number)},
                      {"SLURM_ARRAY_TASK_MIN", "10"},
                      {"SLURM_ARRAY_TASK_COUNT", "2"}});
    };

    QCOMPARE(task(1), 0);
    QCOMPARE(done("array"), QStringList({"s2.json", "s2.stats.json", "s4.json", "s4.stats.json"}));
    QCOMPARE(task(0), 0);
    QCOMPARE(done("array").size(), 10);
    QCOMPARE(runIn(script, {"scans.txt"}), 2);
}

void CliCampaignTest::aScanThatCannotBeReadEndsNoOther()
{
    writeBytes(path("broken.csv"), "nonsense\n");
    writeBytes(path("list.txt"), path("broken.csv").toUtf8() + "\n\n" + path("scans/s5.csv.gz").toUtf8());
    const QString script = QStringLiteral(PLANEWRIGHT_SOURCE_DIR "/resources/campaign/extract.sbatch");

    QCOMPARE(runIn(script, {"list.txt", "rest"}), 3);

    QCOMPARE(done("rest"), QStringList({"s5.json", "s5.stats.json"}));
}

PLANEWRIGHT_TEST(CliCampaignTest)
#include "cli_campaign_test.moc"
