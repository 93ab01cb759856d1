// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/panels/planes_panel.h"

#include <QAction>
#include <QClipboard>
#include <QComboBox>
#include <QLabel>
#include <QSignalSpy>
#include <QtTest>

#include "tests/test_program.h"
#include "tests/ui/made_map.h"
#include "ui/panels/filter_box.h"
#include "ui/panels/filtered_table.h"
#include "ui/panels/underlined_edit.h"

namespace planewright {

class PlanesPanelTest : public QObject {
    Q_OBJECT

private slots:
    void init();
    void theFirstColumnsAreThoseOfTheWindow();
    void whatIsChosenHereIsChosenEverywhere();
    void whatIsChosenElsewhereIsChosenHere();
    void aSelectionSurvivesTheNextMap();
    void aQueryIsTypedAndClearedWithTheKeyboard();
    void aBadQueryIsUnderlinedWithItsReason();
    void aQueryWithoutHitsOffersToClearIt();
    void theFooterSumsUpWhatIsSeenAndWhatIsChosen();
    void beforeTheFirstFitItSaysWhenThatIs();
    void afterAScanWithoutPlanesItOffersWhatToDo();
    void renamingEditsTheNameInTheTable();
    void theClassIsChosenFromAList();
    void spaceHidesAPlane();
    void rowsAreCopiedWithTheirHeadings();
    void ctrlCInTheTableIsTheTablesEvenWhereTheWindowHasIt();
    void aFilterHidesWhatIsChosenAndKeepsIt();
    void thePointerOnARowIsAHover();

private:
    QTableView* view() const { return panel_->table()->view(); }
    QString cell(int row, PlaneColumn column) const
    {
        return view()->model()->index(row, static_cast<int>(column)).data().toString();
    }
    void show();

    std::unique_ptr<PlanesModel> model_;
    std::unique_ptr<MapSelection> selection_;
    std::unique_ptr<PlanesPanel> panel_;
};

namespace {

MadeMap threePlanes()
{
    MadeMap made;
    made.slice(6);
    made.plane(made.wall(0, {{0, 0}}), "floor").outlined(12.0, 4.0, 3.0);
    made.plane(made.wall(3, {{0, 1}, {0, 2}})).outlined(6.5, 3.0, 2.0);
    made.plane(made.wall(7, {{0, 3}, {0, 4}, {0, 5}})).outlined(1.25, 1.0, 1.25);
    return made;
}

}  // namespace

void PlanesPanelTest::init()
{
    panel_.reset();
    model_ = std::make_unique<PlanesModel>();
    selection_ = std::make_unique<MapSelection>();
    panel_ = std::make_unique<PlanesPanel>(*model_, *selection_);
    panel_->resize(420, 400);
    model_->setMap(threePlanes().get());
}

void PlanesPanelTest::show()
{
    panel_->show();
    panel_->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(panel_.get()));
}

void PlanesPanelTest::theFirstColumnsAreThoseOfTheWindow()
{
    QStringList titles;
    for (int column = 0; column < kPlaneColumns; ++column) {
        if (panel_->table()->isColumnShown(column))
            titles << model_->headerData(column, Qt::Horizontal, Qt::DisplayRole).toString();
    }

    QCOMPARE(titles, (QStringList{"", "ID", "Class", "d m", "Area m²", "Seg.", "E", "State"}));
}

void PlanesPanelTest::whatIsChosenHereIsChosenEverywhere()
{
    show();
    view()->setFocus();
    view()->setCurrentIndex(view()->model()->index(0, 1));

    QTest::keyClick(view(), Qt::Key_Down);
    QVERIFY(selection_->planes() == (std::set<PlaneId>{3}));
    QTest::keyClick(view(), Qt::Key_Down, Qt::ShiftModifier);

    QVERIFY(selection_->planes() == (std::set<PlaneId>{3, 7}));
}

void PlanesPanelTest::whatIsChosenElsewhereIsChosenHere()
{
    selection_->select({0, 7});

    QCOMPARE(panel_->table()->chosenRows(), (std::vector<int>{0, 2}));
    QVERIFY(selection_->planes() == (std::set<PlaneId>{0, 7}));
}

void PlanesPanelTest::aSelectionSurvivesTheNextMap()
{
    selection_->select({3});

    MadeMap next;
    next.plane(next.wall(1, {})).plane(next.wall(3, {}, 2)).plane(next.wall(7, {}));
    model_->setMap(next.get());

    QVERIFY(selection_->planes() == (std::set<PlaneId>{3}));
    QCOMPARE(panel_->table()->chosenRows(), (std::vector<int>{1}));
}

void PlanesPanelTest::aQueryIsTypedAndClearedWithTheKeyboard()
{
    show();
    panel_->focusFilter();

    QTest::keyClicks(panel_->table()->filter()->edit(), "class:wall area>2");
    QCOMPARE(view()->model()->rowCount(), 1);
    QCOMPARE(cell(0, PlaneColumn::Id), QStringLiteral("P03"));
    panel_->focusFilter();
    QTest::keyClick(panel_->table()->filter()->edit(), Qt::Key_Delete);

    QCOMPARE(view()->model()->rowCount(), 3);
}

void PlanesPanelTest::aBadQueryIsUnderlinedWithItsReason()
{
    FilterBox* filter = panel_->table()->filter();
    filter->setQuery("class:floor");

    filter->setQuery("class:floor area>x");

    QVERIFY(static_cast<UnderlinedEdit*>(filter->edit())->isUnderlined());
    QCOMPARE(filter->problem(), QStringLiteral("“x” is no number. Write area> and a number, as in 0.5."));
    QCOMPARE(filter->edit()->accessibleDescription(), filter->problem());
    QCOMPARE(view()->model()->rowCount(), 1);
    filter->setQuery("class:floor area>1");
    QVERIFY(!static_cast<UnderlinedEdit*>(filter->edit())->isUnderlined());
    QCOMPARE(filter->problem(), QString());
}

void PlanesPanelTest::aQueryWithoutHitsOffersToClearIt()
{
    panel_->table()->filter()->setQuery("area>20");
    QVERIFY(panel_->table()->shownInstead().contains("Nothing matches <code>area&gt;20</code>"));

    emit panel_->findChild<QLabel*>("emptyText")->linkActivated("clear");

    QCOMPARE(panel_->table()->shownInstead(), QString());
    QCOMPARE(view()->model()->rowCount(), 3);
}

void PlanesPanelTest::theFooterSumsUpWhatIsSeenAndWhatIsChosen()
{
    QCOMPARE(panel_->table()->footer(), QStringLiteral("3 planes, 19.75 m², 6 segments"));

    panel_->table()->filter()->setQuery("class:wall");
    selection_->select({7});

    QCOMPARE(panel_->table()->footer(),
             QStringLiteral("2 planes, 7.75 m², 5 segments\nSelected: 1 plane, 1.25 m², 3 segments"));
    MadeMap made;
    model_->setMap(made.plane(made.wall(0, {})).outlined(2.0, 2.0, 1.0).plane(made.wall(1, {})).get());
    QVERIFY(panel_->table()->footer().startsWith("2 planes, more than 2.00 m²"));
}

void PlanesPanelTest::beforeTheFirstFitItSaysWhenThatIs()
{
    Parameters parameters;
    parameters.schedule.fitEvery = 6;
    panel_->setParameters(parameters);

    model_->setMap(nullptr);

    QCOMPARE(panel_->table()->shownInstead(), QStringLiteral("No planes yet. The first fit happens at step 6."));
}

void PlanesPanelTest::afterAScanWithoutPlanesItOffersWhatToDo()
{
    QSignalSpy unfitted(panel_.get(), &PlanesPanel::showUnfittedRequested);
    QSignalSpy parameter(panel_.get(), &PlanesPanel::parameterRequested);

    model_->setMap(MadeMap().slice(1).finished(41).get());

    const QString text = panel_->table()->shownInstead();
    QVERIFY2(text.startsWith("No plane had N<sub>c</sub> = 5 segments. 41 segments are unfitted."), qPrintable(text));
    auto* label = panel_->findChild<QLabel*>("emptyText");
    emit label->linkActivated("unfitted");
    emit label->linkActivated("planes.min-cluster-segments");
    QCOMPARE(unfitted.size(), 1);
    QCOMPARE(parameter.value(0).value(0).toString(), QStringLiteral("planes.min-cluster-segments"));

    // Where no cluster has to be so large, and where there is nothing at all.
    Parameters parameters;
    parameters.method.estimator = Estimator::Likelihood;
    panel_->setParameters(parameters);
    QVERIFY(panel_->table()->shownInstead().startsWith("No segments gave a plane. 41 segments are unfitted."));
    QVERIFY(!panel_->table()->shownInstead().contains("N<sub>c</sub>"));
    model_->setMap(MadeMap().slice(1).finished(1).get());
    QVERIFY(panel_->table()->shownInstead().contains(" 1 segment is unfitted."));
    model_->setMap(MadeMap().slice(0).finished(0).get());
    QCOMPARE(panel_->table()->shownInstead(), QStringLiteral("No planes: the scan has no line segments."));
}

void PlanesPanelTest::renamingEditsTheNameInTheTable()
{
    show();
    QSignalSpy renamed(model_.get(), &PlanesModel::renameRequested);
    view()->setCurrentIndex(view()->model()->index(1, static_cast<int>(PlaneColumn::Id)));

    panel_->beginRename();
    auto* editor = view()->viewport()->findChild<QLineEdit*>();
    QVERIFY(editor != nullptr);
    QTest::keyClicks(editor, "Left wall");
    QTest::keyClick(editor, Qt::Key_Return);

    QVERIFY(panel_->table()->isColumnShown(static_cast<int>(PlaneColumn::Name)));
    QTRY_COMPARE(renamed.size(), 1);  // the editor is closed a moment later
    QCOMPARE(renamed[0], (QVariantList{3, "Left wall"}));
}

void PlanesPanelTest::theClassIsChosenFromAList()
{
    show();
    QSignalSpy classed(model_.get(), &PlanesModel::classRequested);
    view()->setCurrentIndex(view()->model()->index(0, static_cast<int>(PlaneColumn::Class)));

    QTest::keyClick(view(), Qt::Key_F2);
    auto* editor = view()->viewport()->findChild<QComboBox*>("classEditor");
    QVERIFY(editor != nullptr);
    QCOMPARE(editor->currentText(), QStringLiteral("floor"));
    editor->setCurrentText("door?");
    QTest::keyClick(editor, Qt::Key_Return);

    QTRY_COMPARE(classed.size(), 1);
    QCOMPARE(classed[0], (QVariantList{0, "door?"}));
}

void PlanesPanelTest::spaceHidesAPlane()
{
    show();
    QSignalSpy hidden(model_.get(), &PlanesModel::hideRequested);
    view()->setFocus();
    view()->setCurrentIndex(view()->model()->index(1, static_cast<int>(PlaneColumn::Colour)));

    QTest::keyClick(view(), Qt::Key_Space);

    QCOMPARE(hidden.value(0), (QVariantList{3, true}));
}

void PlanesPanelTest::rowsAreCopiedWithTheirHeadings()
{
    selection_->select({3});

    panel_->table()->copyAction()->trigger();

    QCOMPARE(QGuiApplication::clipboard()->text(), QStringLiteral("\tID\tClass\td m\tArea m²\tSeg.\tE\tState\n"
                                                                  "shown\tP03\twall\t2.00\t6.50\t2\t0.50\tlive\n"));
}

void PlanesPanelTest::ctrlCInTheTableIsTheTablesEvenWhereTheWindowHasIt()
{
    QAction windowCopy;
    windowCopy.setShortcut(QKeySequence::Copy);
    panel_->addAction(&windowCopy);
    QSignalSpy window(&windowCopy, &QAction::triggered);
    QGuiApplication::clipboard()->clear();
    show();
    view()->setFocus();
    selection_->select({3});

    QTest::keyClick(view(), Qt::Key_C, Qt::ControlModifier);

    QCOMPARE(window.size(), 0);
    QVERIFY(QGuiApplication::clipboard()->text().contains("P03"));
}

void PlanesPanelTest::aFilterHidesWhatIsChosenAndKeepsIt()
{
    selection_->select({0, 3});

    panel_->table()->filter()->setQuery("class:floor");
    QVERIFY(selection_->planes() == (std::set<PlaneId>{0, 3}));
    panel_->table()->filter()->setQuery("");

    QCOMPARE(panel_->table()->chosenRows(), (std::vector<int>{0, 1}));
}

void PlanesPanelTest::thePointerOnARowIsAHover()
{
    show();

    QTest::mouseMove(view()->viewport(),
                     view()->visualRect(view()->model()->index(2, static_cast<int>(PlaneColumn::Class))).center());

    QTRY_COMPARE(selection_->hovered(), 7);
    QEvent leave(QEvent::Leave);
    QCoreApplication::sendEvent(view()->viewport(), &leave);
    QCOMPARE(selection_->hovered(), kNoPlane);
}

}  // namespace planewright

PLANEWRIGHT_GUI_TEST(planewright::PlanesPanelTest)
#include "planes_panel_test.moc"
