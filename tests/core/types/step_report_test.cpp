// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/types/step_report.h"

#include <limits>

#include <QtTest>

#include "core/types/error.h"
#include "tests/test_program.h"

namespace planewright {

class StepReportTest : public QObject {
    Q_OBJECT

private slots:
    void aTestHoldsAsItsComparisonSays_data();
    void aTestHoldsAsItsComparisonSays();
    void nothingHoldsOfANumberThatIsNone();
    void namesAreTheWordsOfTheHistoryFile();
    void aFailureCarriesItsCodeAndMessage();
};

void StepReportTest::aTestHoldsAsItsComparisonSays_data()
{
    QTest::addColumn<int>("comparison");
    QTest::addColumn<bool>("below");
    QTest::addColumn<bool>("at");
    QTest::addColumn<bool>("above");
    QTest::newRow("<") << static_cast<int>(Comparison::Less) << true << false << false;
    QTest::newRow("<=") << static_cast<int>(Comparison::LessEqual) << true << true << false;
    QTest::newRow(">") << static_cast<int>(Comparison::Greater) << false << false << true;
    QTest::newRow(">=") << static_cast<int>(Comparison::GreaterEqual) << false << true << true;
}

void StepReportTest::aTestHoldsAsItsComparisonSays()
{
    QFETCH(int, comparison);
    QFETCH(bool, below);
    QFETCH(bool, at);
    QFETCH(bool, above);
    const auto passes = [&](double value) {
        return Test{"plane_distance", value, static_cast<Comparison>(comparison), 0.05}.pass();
    };

    QCOMPARE(passes(0.04), below);
    QCOMPARE(passes(0.05), at);
    QCOMPARE(passes(0.06), above);
    QCOMPARE(name(static_cast<Comparison>(comparison)), std::string_view(QTest::currentDataTag()));
}

void StepReportTest::nothingHoldsOfANumberThatIsNone()
{
    for (const Comparison comparison :
         {Comparison::Less, Comparison::LessEqual, Comparison::Greater, Comparison::GreaterEqual})
        QVERIFY(!(Test{"fitting_error", std::numeric_limits<double>::quiet_NaN(), comparison, 4.0}.pass()));
}

void StepReportTest::namesAreTheWordsOfTheHistoryFile()
{
    QCOMPARE(name(Phase::Extract), std::string_view("extract"));
    QCOMPARE(name(Phase::SplitMerge), std::string_view("split_merge"));
    QCOMPARE(name(Phase::Finish), std::string_view("finish"));
    QCOMPARE(name(DecisionKind::Assign), std::string_view("assign"));
    QCOMPARE(name(DecisionKind::NoFit), std::string_view("no_fit"));
    QCOMPARE(name(DecisionKind::Near), std::string_view("near"));
}

void StepReportTest::aFailureCarriesItsCodeAndMessage()
{
    const Result<int> result = fail(ErrorCode::Unreadable, "scan.csv: line 3: the row is empty");

    QVERIFY(!result);
    QVERIFY(result.error().code == ErrorCode::Unreadable);
    QCOMPARE(result.error().message, std::string("scan.csv: line 3: the row is empty"));
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::StepReportTest)
#include "step_report_test.moc"
