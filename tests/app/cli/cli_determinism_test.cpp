// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <QTemporaryDir>
#include <QTest>

#include "run_program.h"
#include "tests/test_program.h"

/// The same recording and parameters give the same bytes.
class CliDeterminismTest : public QObject {
    Q_OBJECT

private slots:
    void tenRunsGiveTheSameBytes();
    void germanLocaleChangesNothing();

private:
    static QByteArray outputsOf(const QString& scan, const QMap<QString, QString>& environment);
};

QByteArray CliDeterminismTest::outputsOf(const QString& scan, const QMap<QString, QString>& environment)
{
    const QTemporaryDir folder;
    const QStringList names{"p.csv", "p.json", "p.ply", "p.obj", "s.csv", "c.pcd", "labels", "history"};
    const ProgramRun run = runProgram({"extract",    scan,        "--planes", names[0],   "--planes",
                                       names[1],     "--planes",  names[2],   "--planes", names[3],
                                       "--segments", names[4],    "--points", names[5],   "--labels",
                                       names[6],     "--history", names[7],   "-P",       "planes.min-extent=0.25"},
                                      folder.path(), environment);
    QByteArray all = QByteArray::number(run.code) + run.out + run.err;
    for (const QString& name : names)
        all += name.toUtf8() + bytesOf(folder.filePath(name));
    return all;
}

void CliDeterminismTest::tenRunsGiveTheSameBytes()
{
    const QTemporaryDir folder;
    const QString scan = folder.filePath("scan.csv.gz");
    QCOMPARE(runProgram({"simulate", "office", "-o", scan, "--seed", "3"}).code, 0);

    const QByteArray first = outputsOf(scan, {});

    QVERIFY(first.startsWith("0p.csv# format"));
    for (int run = 1; run < 10; ++run)
        QVERIFY(outputsOf(scan, {}) == first);
}

void CliDeterminismTest::germanLocaleChangesNothing()
{
    const QTemporaryDir folder;
    const QMap<QString, QString> english{{"LC_ALL", "C"}, {"LANG", "C"}};
    const QMap<QString, QString> german{{"LC_ALL", "de_DE.UTF-8"}, {"LANG", "de_DE.UTF-8"}};
    const auto simulate = [&](const QString& file, const QMap<QString, QString>& environment) {
        runProgram({"simulate", "corridor", "-o", file, "--tilt", "10.5:170:1.16", "--dropout", "0.5"}, folder.path(),
                   environment);
        return bytesOf(folder.filePath(file));
    };

    const QByteArray scan = simulate("en.csv", english);

    QVERIFY(!scan.isEmpty());
    QCOMPARE(simulate("de.csv", german), scan);
    const QString path = folder.filePath("en.csv");
    QVERIFY(outputsOf(path, german) == outputsOf(path, english));
    QCOMPARE(runProgram({"params", "--json"}, {}, german).out, runProgram({"params", "--json"}, {}, english).out);
    QCOMPARE(runProgram({"info", path}, {}, german).out, runProgram({"info", path}, {}, english).out);
}

PLANEWRIGHT_TEST(CliDeterminismTest)
#include "cli_determinism_test.moc"
