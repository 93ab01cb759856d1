// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/formats/history.h"

#include <limits>
#include <sstream>

#include <QJsonDocument>
#include <QJsonObject>
#include <QtTest>

#include "core/types/angle.h"
#include "tests/test_program.h"

using namespace planewright;

class HistoryTest : public QObject {
    Q_OBJECT

private slots:
    void theFirstLineHasFormatAndParameters();
    void aLineHasCountsAndDecisions();
    void theLastPassSaysSo();
    void timesAreThereWhenAskedFor();
    void everyComparisonHasItsSign();
    void aFullDiskIsNotSilent();
};

void HistoryTest::theFirstLineHasFormatAndParameters()
{
    std::ostringstream out;
    QVERIFY(writeHistoryHeader(out, {}).has_value());
    const QByteArray line = QByteArray::fromStdString(out.str());

    QVERIFY(line.startsWith(
        R"({"format":"planewright-history 1","parameters":{"method.estimator":"end-points","noise.range-constant":0.008,)"));
    QCOMPARE(line.count('\n'), 1);
    QVERIFY(line.endsWith("}}\n"));
    QVERIFY(QJsonDocument::fromJson(line)["parameters"].toObject().contains("planes.cost"));
}

void HistoryTest::aLineHasCountsAndDecisions()
{
    StepReport report;
    report.step = 6;
    report.tilt = degrees(16.96);
    report.counts = {721, 9, 4, 5, 31, 12, 5, 3, 0, 0, 0.0};
    report.decisions = {{Phase::SplitMerge,
                         DecisionKind::Assign,
                         {SegmentId{6, 2}, PlaneRef{3}},
                         {{"plane_distance", 0.012, Comparison::Less, 0.05}, {"angle", 0.2, Comparison::Less, 0.1}},
                         {PlaneRef{3}}},
                        {Phase::Fit, DecisionKind::NoFit, {ClusterRef{4}}, {}, {}},
                        {Phase::Extract,
                         DecisionKind::Reject,
                         {PieceRef{6, 47, 51}},
                         {{"points", 5.0, Comparison::GreaterEqual, 7.0}},
                         {}}};
    std::ostringstream out;

    QVERIFY(writeHistoryLine(out, report, false).has_value());

    QCOMPARE(
        out.str(),
        std::string(R"({"step":6,"pitch_deg":16.96,"counts":{"returns":721,"segments":9,"assigned":4,"clustered":5,)"
                    R"("fitted":31,"unfitted":12,"clusters":5,"planes":3},"decisions":[{"phase":"split_merge",)"
                    R"("kind":"assign","operands":["6.2","P3"],"tests":[{"name":"plane_distance","value":0.012,)"
                    R"("op":"<","limit":0.05,"pass":true},{"name":"angle","value":0.2,"op":"<","limit":0.1,)"
                    R"("pass":false}],"result":["P3"]},{"phase":"fit","kind":"no_fit","operands":["C4"],)"
                    R"("tests":[],"result":[]},{"phase":"extract","kind":"reject","operands":["6:47-51"],)"
                    R"("tests":[{"name":"points","value":5,"op":">=","limit":7,"pass":false}],"result":[]}]})"
                    "\n"));
}

void HistoryTest::theLastPassSaysSo()
{
    StepReport report;
    report.step = -1;
    report.tilt = degrees(170.0);
    std::ostringstream out;

    QVERIFY(writeHistoryLine(out, report, false).has_value());

    QCOMPARE(
        out.str(),
        std::string(R"({"step":-1,"phase":"finish","pitch_deg":170,"counts":{"returns":0,"segments":0,"assigned":0,)"
                    R"("clustered":0,"fitted":0,"unfitted":0,"clusters":0,"planes":0},"decisions":[]})"
                    "\n"));
}

void HistoryTest::timesAreThereWhenAskedFor()
{
    StepReport report;
    report.times = {std::chrono::nanoseconds(5500), std::chrono::milliseconds(2)};
    std::ostringstream out;

    QVERIFY(writeHistoryLine(out, report, true).has_value());

    QVERIFY(out.str().find(R"(},"times_ms":{"extract":0.0055,"assign":2,"cluster":0,"fit":0,"split_merge":0,)"
                           R"("remaining":0,"finish":0},"decisions":[]})") != std::string::npos);
}

void HistoryTest::everyComparisonHasItsSign()
{
    const double unknown = std::numeric_limits<double>::quiet_NaN();
    StepReport report;
    report.decisions = {{Phase::Assign,
                         DecisionKind::Reject,
                         {},
                         {{"a", 1, Comparison::LessEqual, 1},
                          {"b", 1, Comparison::Greater, 1},
                          {"c", 1, Comparison::GreaterEqual, 1},
                          {"d", unknown, Comparison::Less, 1}},
                         {}}};
    std::ostringstream out;

    QVERIFY(writeHistoryLine(out, report, false).has_value());

    QVERIFY(out.str().find(R"("tests":[{"name":"a","value":1,"op":"<=","limit":1,"pass":true},)"
                           R"({"name":"b","value":1,"op":">","limit":1,"pass":false},)"
                           R"({"name":"c","value":1,"op":">=","limit":1,"pass":true},)"
                           R"({"name":"d","value":null,"op":"<","limit":1,"pass":false}])") != std::string::npos);
}

void HistoryTest::aFullDiskIsNotSilent()
{
    std::ostringstream out;
    out.setstate(std::ios::badbit);

    QCOMPARE(writeHistoryHeader(out, {}).error().code, ErrorCode::NotWritten);
    QCOMPARE(writeHistoryLine(out, {}, true).error().code, ErrorCode::NotWritten);
}

PLANEWRIGHT_TEST(HistoryTest)
#include "history_test.moc"
