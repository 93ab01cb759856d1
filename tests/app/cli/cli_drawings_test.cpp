// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include "run_program.h"
#include "tests/test_program.h"

class CliDrawingsTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void drawingsHaveALayerForEachClass();
    void planIsCutWhereItIsAskedFor();
    void planWithoutAFloorIsCutAtThePitchAxis();
    void aReportIsOnePageOfTheScan();
    void drawingsPassTheAuditOfEzdxf();

private:
    /// What ezdxf says of a drawing.
    QByteArray auditOf(const QString& name) const;
    ProgramRun extract(const QStringList& options) const
    {
        return runProgram(QStringList{"extract", "scan.csv"} + options, folder_.path());
    }
    QString path(const QString& name) const { return folder_.filePath(name); }

    QTemporaryDir folder_;
};

void CliDrawingsTest::initTestCase()
{
    QCOMPARE(simulateTwelve(folder_.path()).code, 0);
}

void CliDrawingsTest::drawingsHaveALayerForEachClass()
{
    const ProgramRun run = extract({"--planes", "d.dxf", "--floor-plan", "plan.dxf", "--planes", "d.csv"});
    const QByteArray drawing = bytesOf(path("d.dxf"));
    const QByteArray plan = bytesOf(path("plan.dxf"));

    QVERIFY2(run.code == 0, run.err);
    QCOMPARE(drawing.count("  0\nLAYER\n"), 3);
    for (const char* layer : {"floor", "ceiling", "wall"}) {
        QVERIFY(drawing.contains(QByteArray("  0\n3DFACE\n  8\n") + layer + "\n"));
        QVERIFY(bytesOf(path("d.csv")).contains(QByteArray(",") + layer + "\n"));
    }
    QVERIFY(!plan.contains("3DFACE"));
    QVERIFY(plan.count("  0\nLINE\n  8\nwall\n") >= 10);  // the room has ten walls
    QCOMPARE(plan.count("  0\nLINE\n"), plan.count("  0\nLINE\n  8\nwall\n"));
}

void CliDrawingsTest::planIsCutWhereItIsAskedFor()
{
    // Its walls end at the ceiling, 2.9 m above its floor.
    QCOMPARE(extract({"--floor-plan", "high.dxf", "--cut-height", "3.5"}).code, 0);
    QCOMPARE(extract({"--floor-plan", "low.dxf", "--cut-height", "0.5"}).code, 0);

    QCOMPARE(bytesOf(path("high.dxf")).count("  0\nLINE\n"), 0);
    QVERIFY(bytesOf(path("low.dxf")).count("  0\nLINE\n") >= 10);
    QCOMPARE(extract({"--floor-plan", "x.dxf", "--cut-height", "-1"}).code, 2);
    QCOMPARE(extract({"--floor-plan", "x.svg"}).code, 2);
}

void CliDrawingsTest::planWithoutAFloorIsCutAtThePitchAxis()
{
    const ProgramRun run = extract({"--floor-plan", "few.dxf", "--until", "0"});

    QCOMPARE(run.code, 0);
    QCOMPARE(run.err, QByteArray("planewright-cli: warning: no floor is found; the plan is cut at the height of the "
                                 "pitch axis\n"));
}

void CliDrawingsTest::aReportIsOnePageOfTheScan()
{
    const ProgramRun run = extract({"--report", "scan.html", "--planes", "r.csv"});
    const QByteArray page = bytesOf(path("scan.html"));

    QVERIFY2(run.code == 0, run.err);
    QVERIFY(page.startsWith("<!DOCTYPE html>"));
    QVERIFY(page.contains("<h1>scan.csv</h1>"));
    QCOMPARE(page.count("<svg "), 4);  // a plan and three sides: a scan from 10° to 170° does not see what is behind
    for (const char* plane : {"P00", "P01"})
        QVERIFY(page.contains(QByteArray("<td class=\"word\">") + plane + "</td>"));
    QVERIFY(!page.contains("http://") || page.count("http://") == page.count("xmlns=\"http://www.w3.org/2000/svg\""));
    QCOMPARE(extract({"--report", "again.html"}).code, 0);
    QCOMPARE(bytesOf(path("again.html")), page);
    QCOMPARE(extract({"--report", "x.pdf"}).code, 2);
}

QByteArray CliDrawingsTest::auditOf(const QString& name) const
{
    QProcess audit;
    audit.setWorkingDirectory(folder_.path());
    audit.start(QStringLiteral("ezdxf"), {QStringLiteral("audit"), name});
    return audit.waitForFinished(60'000) ? audit.readAll() : "ezdxf does not run: " + audit.errorString().toUtf8();
}

void CliDrawingsTest::drawingsPassTheAuditOfEzdxf()
{
    QCOMPARE(extract({"--planes", "scan.dxf", "--floor-plan", "scan-plan.dxf"}).code, 0);
    QCOMPARE(runProgram({"simulate", "building", "--floors", "2", "--stops", "3", "-o", "floors.pwscan",
                         "--truth-poses", "poses.txt"},
                        folder_.path())
                 .code,
             0);
    writeBytes(path("floors.txt"), "0 0 0 0 0 0 0 1\n1 0 0 3.2 0 0 0 1\n");
    const ProgramRun map = runProgram(
        {"map", "floors.pwscan", "--floor-poses", "floors.txt", "--planes", "map.dxf", "--floor-plan", "map-plan.dxf"},
        folder_.path());
    QVERIFY2(map.code == 0, map.err);

    for (const char* drawing : {"scan.dxf", "scan-plan.dxf", "map.dxf", "map-plan-floor-0.dxf", "map-plan-floor-1.dxf"})
        QVERIFY2(auditOf(drawing).contains("No errors found."), drawing + (": " + auditOf(drawing)));
    // What is no drawing is told.
    writeBytes(path("broken.dxf"), bytesOf(path("scan-plan.dxf")).replace("  0\nLINE\n", "  0\nLYNE\n"));
    QVERIFY(!auditOf("broken.dxf").contains("No errors found."));
}

PLANEWRIGHT_TEST(CliDrawingsTest)
#include "cli_drawings_test.moc"
