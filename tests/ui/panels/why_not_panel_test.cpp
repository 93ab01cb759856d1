// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/panels/why_not_panel.h"

#include <QClipboard>
#include <QComboBox>
#include <QLineEdit>
#include <QSignalSpy>
#include <QTableView>
#include <QtTest>

#include "tests/test_program.h"

namespace planewright {

class WhyNotPanelTest : public QObject {
    Q_OBJECT

private slots:
    void theBoxesTakePlanesAndSegments();
    void theBoxesKeepWhatWasChosen();
    void typingAsks();
    void theAnswerIsASentenceAndATable();
    void aProblemStandsInThePanel();
    void aConditionLeadsToItsParameter();
    void conditionsAreCopied();
};

namespace {

WhyNot stayTwo()
{
    return {{PlaneRef{3}, PlaneRef{11}},
            false,
            {{"merge",
              {{"normal_alignment", 0.9991, Comparison::Greater, 0.9962},
               {"plane_distance", 0.061, Comparison::Less, 0.025}}}}};
}

QComboBox* boxOf(const WhyNotPanel& panel, const char* name)
{
    return panel.findChild<QComboBox*>(QLatin1String(name));
}

}  // namespace

void WhyNotPanelTest::theBoxesTakePlanesAndSegments()
{
    WhyNotPanel panel;
    QVERIFY(!panel.first() && !panel.second());

    panel.setOperands(SegmentId{63, 3}, PlaneRef{7});

    QCOMPARE(boxOf(panel, "whyNotFirst")->currentText(), QStringLiteral("64.3"));
    QCOMPARE(boxOf(panel, "whyNotSecond")->currentText(), QStringLiteral("P07"));
    QVERIFY(std::get<SegmentId>(*panel.first()) == (SegmentId{63, 3}));
    QCOMPARE(std::get<PlaneRef>(*panel.second()).id, 7);
}

void WhyNotPanelTest::theBoxesKeepWhatWasChosen()
{
    WhyNotPanel panel;
    panel.setOperands(PlaneRef{3}, PlaneRef{11});
    QSignalSpy asked(&panel, &WhyNotPanel::asked);

    panel.setPlanes({0, 3, 5});

    QCOMPARE(boxOf(panel, "whyNotFirst")->count(), 3);
    QCOMPARE(boxOf(panel, "whyNotSecond")->currentText(), QStringLiteral("P11"));
    QVERIFY(asked.isEmpty());
}

void WhyNotPanelTest::typingAsks()
{
    WhyNotPanel panel;
    panel.show();
    panel.activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&panel));
    QSignalSpy asked(&panel, &WhyNotPanel::asked);
    QLineEdit* line = boxOf(panel, "whyNotFirst")->lineEdit();
    line->setFocus();

    QTest::keyClicks(line, QStringLiteral("p7"));
    QTest::keyClick(line, Qt::Key_Return);

    QVERIFY(asked.count() >= 1);
    QCOMPARE(std::get<PlaneRef>(*panel.first()).id, 7);
}

void WhyNotPanelTest::theAnswerIsASentenceAndATable()
{
    WhyNotPanel panel;
    panel.setAnswer(stayTwo(), QStringLiteral("64"));

    QCOMPARE(panel.sentence(), QStringLiteral("Step 64: P03 and P11 stay two: no way has all its conditions."));
    QVERIFY(!panel.table()->isHidden());
    QCOMPARE(panel.table()->columnSpan(0, 0), kWhyNotColumns);
    QCOMPARE(panel.table()->columnSpan(1, 0), 1);
}

void WhyNotPanelTest::aProblemStandsInThePanel()
{
    WhyNotPanel panel;
    panel.setAnswer(stayTwo(), QStringLiteral("64"));

    panel.setProblem(QStringLiteral("There is no P11 at step 3."));

    QCOMPARE(panel.sentence(), QStringLiteral("There is no P11 at step 3."));
    QVERIFY(panel.table()->isHidden());
    QCOMPARE(panel.model().rowCount(), 0);
}

void WhyNotPanelTest::aConditionLeadsToItsParameter()
{
    WhyNotPanel panel;
    panel.setAnswer(stayTwo(), QStringLiteral("64"));
    panel.show();
    panel.activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&panel));
    QSignalSpy asked(&panel, &WhyNotPanel::parameterRequested);
    panel.table()->setFocus();
    panel.table()->selectRow(2);

    QTest::keyClick(panel.table(), Qt::Key_Return);

    QCOMPARE(asked.count(), 1);
    QCOMPARE(asked[0][0].toString(), QStringLiteral("planes.merge-distance"));
}

void WhyNotPanelTest::conditionsAreCopied()
{
    WhyNotPanel panel;
    panel.setAnswer(stayTwo(), QStringLiteral("64"));
    panel.show();
    panel.activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&panel));
    panel.table()->setFocus();
    panel.table()->selectRow(2);

    QTest::keyClick(panel.table(), Qt::Key_C, Qt::ControlModifier);

    QCOMPARE(QGuiApplication::clipboard()->text(),
             QStringLiteral("Way\tCondition\tValue\tComparison\tLimit\tHolds\nMerge\tD\t0.061 m\t<\t0.025 m\tno\n"));
}

}  // namespace planewright

PLANEWRIGHT_GUI_TEST(planewright::WhyNotPanelTest)
#include "why_not_panel_test.moc"
