// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>

#include "run_program.h"
#include "tests/test_program.h"

namespace {

/// Planes z = d of these ids and distances.
QByteArray planesText(const QList<QPair<int, double>>& planes)
{
    QByteArray text = "# format = planewright-planes 1\nid,nx,ny,nz,d,points\n";
    for (const auto& [id, distance] : planes)
        text += QByteArray::number(id) + ",0,0,1," + QByteArray::number(distance) + ",100\n";
    return text;
}

}  // namespace

class CliCompareTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void planesFoundInATruthWithoutNoiseMatchIt();
    void byParametersCountsMatchedAndUnmatched();
    void textHasTheKeysOfTheJson();
    void gateFailsAboveItsNumber();
    void byLabelsGivesHooversSets();
    void gateCountsGroupsByLabels();
    void labelsOfAnotherScanAreAnError();
    void labelsOfOtherPlanesAreAnError();
    void unknownKindIsWrongUsage();
    void malformedPlanesNameTheirLine();

private:
    ProgramRun compare(const QStringList& options) const
    {
        return runProgram(QStringList{"compare"} + options, folder_.path());
    }

    QTemporaryDir folder_;
};

void CliCompareTest::initTestCase()
{
    writeBytes(folder_.filePath("a.csv"), planesText({{0, 1.0}, {1, 2.02}, {2, 5.0}}));
    writeBytes(folder_.filePath("b.csv"), planesText({{7, 2.0}, {8, 1.0}, {9, 3.0}}));
    writeBytes(folder_.filePath("a.labels"), "0 0 1 1\n2 2 -1 -1\n");
    writeBytes(folder_.filePath("b.labels"), "8 8 7 7\n-2 -2 9 9\n");
}

void CliCompareTest::planesFoundInATruthWithoutNoiseMatchIt()
{
    const QTemporaryDir folder;
    QCOMPARE(simulateTwelve(folder.path()).code, 0);
    runProgram({"extract", "scan.csv", "--planes", "p.csv", "--planes", "p.json", "--labels", "p.labels"},
               folder.path());

    const ProgramRun labels = runProgram({"compare", "p.csv", "truth.csv", "--labels", "p.labels", "truth.labels",
                                          "--min-returns", "400", "--json", "--fail-above", "0"},
                                         folder.path());
    const ProgramRun parameters = runProgram({"compare", "p.json", "truth.csv", "--angle", "0.5", "--distance", "0.005",
                                              "--min-returns", "400", "--fail-above", "0"},
                                             folder.path());

    QCOMPARE(labels.code, 0);
    const QJsonDocument facts = QJsonDocument::fromJson(labels.out);
    QCOMPARE(facts["recall"].toDouble(), 1.0);
    QCOMPARE(facts["precision"].toDouble(), 1.0);
    QVERIFY(facts["distance_error_m"]["max"].toDouble() < 0.005);
    QCOMPARE(parameters.code, 0);
}

void CliCompareTest::byParametersCountsMatchedAndUnmatched()
{
    const ProgramRun run = compare({"a.csv", "b.csv", "--json"});
    const QJsonDocument facts = QJsonDocument::fromJson(run.out);

    QCOMPARE(run.code, 0);
    QCOMPARE(facts["matched"].toInt(), 2);
    QCOMPARE(facts["unmatched_a"].toInt(), 1);
    QCOMPARE(facts["unmatched_b"].toInt(), 1);
    QCOMPARE(facts["unmatched_a_planes"].toArray(), QJsonArray{2});
    QCOMPARE(facts["unmatched_b_planes"].toArray(), QJsonArray{9});
    QCOMPARE(facts["angle_error_deg"]["max"].toDouble(), 0.0);
    QCOMPARE(facts["distance_error_m"]["max"].toDouble(), 0.02);
    QCOMPARE(facts["distance_error_m"]["mean"].toDouble(), 0.01);
}

void CliCompareTest::textHasTheKeysOfTheJson()
{
    for (const QStringList& how : {QStringList{}, QStringList{"--labels", "a.labels", "b.labels"}}) {
        const ProgramRun json = compare(QStringList{"a.csv", "b.csv", "--json"} + how);
        const ProgramRun text = compare(QStringList{"a.csv", "b.csv"} + how);
        QCOMPARE(text.code, 0);
        for (const QByteArray& line : text.out.trimmed().split('\n'))
            QVERIFY(QJsonDocument::fromJson(json.out).object().contains(line.left(line.indexOf(' '))));
    }
}

void CliCompareTest::gateFailsAboveItsNumber()
{
    const ProgramRun failed = compare({"a.csv", "b.csv", "--fail-above", "0"});
    const ProgramRun passed = compare({"a.csv", "b.csv", "--fail-above", "1"});

    QCOMPARE(failed.code, 8);
    QVERIFY(!failed.out.isEmpty());
    QCOMPARE(failed.err,
             QByteArray("planewright-cli: b.csv: 1 planes have no match in a.csv, --fail-above allows 0\n"));
    QCOMPARE(passed.code, 0);
}

void CliCompareTest::byLabelsGivesHooversSets()
{
    const ProgramRun run = compare({"a.csv", "b.csv", "--labels", "a.labels", "b.labels", "--json"});
    const QJsonDocument facts = QJsonDocument::fromJson(run.out);

    QCOMPARE(run.code, 0);
    QCOMPARE(facts["correct"].toInt(), 2);
    QCOMPARE(facts["missed"].toInt(), 1);
    QCOMPARE(facts["noise"].toInt(-1), 0);
    QCOMPARE(facts["ignored"].toInt(), 1);
    QCOMPARE(facts["missed_planes"].toArray(), QJsonDocument::fromJson("[[9]]").array());
    QCOMPARE(facts["recall"].toDouble(), 0.666666667);
    QCOMPARE(facts["precision"].toDouble(), 1.0);
    QCOMPARE(facts["f1"].toDouble(), 0.8);
}

void CliCompareTest::gateCountsGroupsByLabels()
{
    const QStringList labels{"a.csv", "b.csv", "--labels", "a.labels", "b.labels", "--fail-above", "0"};

    QCOMPARE(compare(labels).code, 8);
    QCOMPARE(compare(labels + QStringList{"--min-returns", "3"}).code, 0);
}

void CliCompareTest::labelsOfAnotherScanAreAnError()
{
    writeBytes(folder_.filePath("short.labels"), "8 8 7 7\n");

    const ProgramRun run = compare({"a.csv", "b.csv", "--labels", "a.labels", "short.labels"});

    QCOMPARE(run.code, 3);
    QCOMPARE(run.err, QByteArray("planewright-cli: a.labels, short.labels: 2 lines against 1; both labellings must be "
                                 "of the same recording\n"));
}

void CliCompareTest::labelsOfOtherPlanesAreAnError()
{
    const ProgramRun run = compare({"a.csv", "b.csv", "--labels", "b.labels", "b.labels"});

    QCOMPARE(run.code, 3);
    QVERIFY2(run.err.contains("the labels of A name plane 7, which its planes do not list"), run.err);
}

void CliCompareTest::unknownKindIsWrongUsage()
{
    const ProgramRun run = compare({"a.ply", "b.csv"});

    QCOMPARE(run.code, 2);
    QVERIFY2(run.err.contains("a.ply: "), run.err);
}

void CliCompareTest::malformedPlanesNameTheirLine()
{
    writeBytes(folder_.filePath("bad.csv"), "# format = planewright-planes 1\nid,nx,ny,nz,d\n0,0,0,x,1\n");

    const ProgramRun run = compare({"bad.csv", "b.csv"});

    QCOMPARE(run.code, 3);
    QVERIFY2(run.err.startsWith("planewright-cli: bad.csv: line 3, column 4"), run.err);
}

PLANEWRIGHT_TEST(CliCompareTest)
#include "cli_compare_test.moc"
