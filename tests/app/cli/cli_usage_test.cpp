// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <QProcess>
#include <QTest>

#include "run_program.h"
#include "tests/test_program.h"

class CliUsageTest : public QObject {
    Q_OBJECT

private slots:
    void helpIsOnStandardOutput_data();
    void helpIsOnStandardOutput();
    void versionIsTheProjects();
    void wrongUsageIsOneLineThatPointsToHelp_data();
    void wrongUsageIsOneLineThatPointsToHelp();
    void standardOutputThatIsFullIsAnError();
};

void CliUsageTest::helpIsOnStandardOutput_data()
{
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<QString>("says");
    QTest::newRow("program") << QStringList{"--help"} << "extract";
    QTest::newRow("extract") << QStringList{"extract", "--help"} << "--planes";
    QTest::newRow("simulate") << QStringList{"simulate", "-h"} << "--truth-labels";
    QTest::newRow("convert") << QStringList{"convert", "--help"} << "--overwrite";
    QTest::newRow("info") << QStringList{"info", "--help"} << "--json";
    QTest::newRow("validate") << QStringList{"validate", "--help"} << "--json";
    QTest::newRow("compare") << QStringList{"compare", "--help"} << "--fail-above";
    QTest::newRow("params") << QStringList{"params", "--help"} << "--markdown";
    QTest::newRow("params show") << QStringList{"params", "show", "--help"} << "KEY";
}

void CliUsageTest::helpIsOnStandardOutput()
{
    QFETCH(QStringList, arguments);
    QFETCH(QString, says);

    const ProgramRun run = runProgram(arguments);

    QCOMPARE(run.code, 0);
    QVERIFY(QString::fromUtf8(run.out).contains(says));
    QCOMPARE(run.err, QByteArray());
}

void CliUsageTest::versionIsTheProjects()
{
    const ProgramRun run = runProgram({"--version"});

    QCOMPARE(run.code, 0);
    QCOMPARE(run.out, QByteArray("planewright-cli " PLANEWRIGHT_VERSION "\n"));
}

void CliUsageTest::wrongUsageIsOneLineThatPointsToHelp_data()
{
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<QString>("names");
    QTest::addColumn<QString>("help");
    const QString all = "'planewright-cli --help'";
    const QString extract = "'planewright-cli extract --help'";
    const QString compare = "'planewright-cli compare --help'";
    QTest::newRow("nothing") << QStringList{} << "give a command" << all;
    QTest::newRow("unknown command") << QStringList{"frobnicate"} << "frobnicate" << all;
    QTest::newRow("option before the command") << QStringList{"--frob"} << "there is no option '--frob'" << all;
    QTest::newRow("unknown option") << QStringList{"extract", "a.csv", "--frob"} << "--frob" << extract;
    QTest::newRow("no input") << QStringList{"extract"} << "INPUT" << extract;
    QTest::newRow("two inputs") << QStringList{"extract", "a.csv", "b.csv"} << "b.csv" << extract;
    QTest::newRow("option without value") << QStringList{"extract", "a.csv", "--labels"} << "--labels" << extract;
    for (const char* option : {"--planes", "--segments", "--points", "--labels", "--history", "--stats", "--sensor"})
        QTest::newRow(qPrintable(QString("empty ") + option))
            << QStringList{"extract", "a.csv", option, ""} << QString(option) + ": give a value" << extract;
    QTest::newRow("empty input") << QStringList{"extract", ""} << "INPUT: give a value" << extract;
    QTest::newRow("no number") << QStringList{"extract", "a.csv", "--until", "x"} << "--until" << extract;
    QTest::newRow("negative step") << QStringList{"extract", "a.csv", "--until", "-1"} << "--until" << extract;
    QTest::newRow("no repeat") << QStringList{"extract", "a.csv", "--repeat", "0"} << "--repeat" << extract;
    QTest::newRow("overlap of 2") << QStringList{"compare", "a.csv", "b.csv", "--labels", "c", "d", "--overlap", "2"}
                                  << "--overlap" << compare;
    QTest::newRow("overlap that is no number")
        << QStringList{"compare", "a.csv", "b.csv", "--labels", "c", "d", "--overlap", "nan"} << "--overlap" << compare;
    QTest::newRow("overlap without labels")
        << QStringList{"compare", "a.csv", "b.csv", "--overlap", "0.5"} << "--overlap" << compare;
    QTest::newRow("one label file") << QStringList{"compare", "a.csv", "b.csv", "--labels", "c"} << "--labels"
                                    << compare;
}

void CliUsageTest::wrongUsageIsOneLineThatPointsToHelp()
{
    QFETCH(QStringList, arguments);
    QFETCH(QString, names);
    QFETCH(QString, help);

    const ProgramRun run = runProgram(arguments);
    const QString err = QString::fromUtf8(run.err);

    QCOMPARE(run.code, 2);
    QCOMPARE(run.out, QByteArray());
    QVERIFY2(err.startsWith("planewright-cli: "), run.err);
    QCOMPARE(err.count('\n'), 1);
    QVERIFY2(err.contains(names), run.err);
    QVERIFY2(err.endsWith("; see " + help + "\n"), run.err);
}

void CliUsageTest::standardOutputThatIsFullIsAnError()
{
    QProcess shell;
    shell.start("/bin/sh", {"-c", "'" PLANEWRIGHT_CLI "' params > /dev/full"});
    shell.waitForFinished(-1);

    QCOMPARE(shell.exitCode(), 5);
    QCOMPARE(shell.readAllStandardError(),
             QByteArray("planewright-cli: standard output: No space left on device; send it "
                        "to a file or program that takes it\n"));
}

PLANEWRIGHT_TEST(CliUsageTest)
#include "cli_usage_test.moc"
