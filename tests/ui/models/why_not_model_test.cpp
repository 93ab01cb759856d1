// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/models/why_not_model.h"

#include <QAbstractItemModelTester>
#include <QtTest>

#include "tests/test_program.h"
#include "ui/models/model_roles.h"

namespace planewright {

class WhyNotModelTest : public QObject {
    Q_OBJECT

private slots:
    void waysAndTheirConditionsAreRows();
    void whatFailsIsMarked();
    void conditionsLeadToTheirParameters();
};

namespace {

WhyNot twoPlanes()
{
    return {{PlaneRef{3}, PlaneRef{11}},
            false,
            {{"merge",
              {{"normal_alignment", 0.9991, Comparison::Greater, 0.9962},
               {"plane_distance", 0.061, Comparison::Less, 0.025}}},
             {"absorb", {{"shared_segments", 0.75, Comparison::GreaterEqual, 0.6}}}}};
}

QStringList rowTexts(const WhyNotModel& model, int row)
{
    QStringList texts;
    for (int column = 0; column < kWhyNotColumns; ++column)
        texts << model.index(row, column).data().toString();
    return texts;
}

}  // namespace

void WhyNotModelTest::waysAndTheirConditionsAreRows()
{
    WhyNotModel model;
    const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
    model.setAnswer(twoPlanes());

    QCOMPARE(model.rowCount(), 5);
    QVERIFY(model.isWay(0) && !model.isWay(1) && !model.isWay(2) && model.isWay(3));
    QCOMPARE(rowTexts(model, 0), (QStringList{"Merge: 1 of 2 fail ✘", "", "", "", ""}));
    QCOMPARE(rowTexts(model, 1), (QStringList{"|n·n|", "0.9991", ">", "0.9962", "✔"}));
    QCOMPARE(rowTexts(model, 2), (QStringList{"D", "0.061 m", "<", "0.025 m", "✘"}));
    QCOMPARE(rowTexts(model, 3),
             (QStringList{"The larger takes in the smaller: its condition holds ✔", "", "", "", ""}));
    QCOMPARE(rowTexts(model, 4), (QStringList{"shared", "75 %", "≥", "60 %", "✔"}));
    model.setAnswer(std::nullopt);
    QCOMPARE(model.rowCount(), 0);
}

void WhyNotModelTest::whatFailsIsMarked()
{
    WhyNotModel model;
    model.setAnswer(twoPlanes());
    const auto toneOf = [&](int row, WhyNotColumn column) {
        return model.index(row, static_cast<int>(column)).data(kLineRole).value<TextLine>().parts.front().tone;
    };

    QCOMPARE(toneOf(2, WhyNotColumn::Value), TextTone::Fail);
    QCOMPARE(toneOf(2, WhyNotColumn::Limit), TextTone::Plain);
    QCOMPARE(toneOf(1, WhyNotColumn::Value), TextTone::Plain);
    QCOMPARE(toneOf(1, WhyNotColumn::Verdict), TextTone::Pass);
    QCOMPARE(model.index(2, 4).data(Qt::AccessibleTextRole).toString(), QStringLiteral("does not hold"));
}

void WhyNotModelTest::conditionsLeadToTheirParameters()
{
    WhyNotModel model;
    model.setAnswer(twoPlanes());

    QVERIFY(model.parameterAt(0).empty());
    QVERIFY(model.parameterAt(2) == "planes.merge-distance");
    QVERIFY(model.parameterAt(4) == "planes.merge-share");
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::WhyNotModelTest)
#include "why_not_model_test.moc"
