// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/panels/segments_panel.h"

#include <QCheckBox>
#include <QtTest>

#include "tests/test_program.h"
#include "tests/ui/made_map.h"
#include "ui/panels/filter_box.h"
#include "ui/panels/filtered_table.h"

namespace planewright {

class SegmentsPanelTest : public QObject {
    Q_OBJECT

private slots:
    void init();
    void unfittedSegmentsAloneCanBeShown();
    void aQueryHoldsBesideTheCheckBox();
    void theSelectionIsShared();
    void itSaysWhyItIsEmpty();

private:
    std::unique_ptr<SegmentsModel> model_;
    std::unique_ptr<MapSelection> selection_;
    std::unique_ptr<SegmentsPanel> panel_;
};

void SegmentsPanelTest::init()
{
    panel_.reset();
    model_ = std::make_unique<SegmentsModel>();
    selection_ = std::make_unique<MapSelection>();
    panel_ = std::make_unique<SegmentsPanel>(*model_, *selection_);
    MadeMap made;
    made.slice(3).slice(2);
    model_->setMap(made.plane(made.wall(4, {{0, 0}, {1, 0}})).get());
}

void SegmentsPanelTest::unfittedSegmentsAloneCanBeShown()
{
    QCOMPARE(panel_->table()->footer(), QStringLiteral("5 of 5 segments shown, 3 unfitted"));

    QTest::keyClick(panel_->findChild<QCheckBox*>("unfittedOnly"), Qt::Key_Space);
    QCOMPARE(panel_->table()->footer(), QStringLiteral("3 of 5 segments shown, 3 unfitted"));
    panel_->showUnfittedOnly(false);

    QCOMPARE(panel_->table()->rows()->rowCount(), 5);
}

void SegmentsPanelTest::aQueryHoldsBesideTheCheckBox()
{
    panel_->showUnfittedOnly(true);

    panel_->table()->filter()->setQuery("step=2");

    QCOMPARE(panel_->table()->rows()->rowCount(), 1);
}

void SegmentsPanelTest::theSelectionIsShared()
{
    selection_->select({}, {{1, 0}, {0, 2}});
    QCOMPARE(panel_->table()->chosenRows(), (std::vector<int>{2, 3}));

    panel_->table()->view()->selectRow(0);

    QVERIFY(selection_->segments() == (std::set<SegmentId>{{0, 0}}));
}

void SegmentsPanelTest::itSaysWhyItIsEmpty()
{
    model_->setMap(nullptr);
    QCOMPARE(panel_->table()->shownInstead(), QStringLiteral("No segments yet. They come with the first slice."));

    panel_->showUnfittedOnly(true);
    MadeMap made;
    made.slice(1);
    model_->setMap(made.plane(made.wall(0, {{0, 0}})).get());

    QCOMPARE(panel_->table()->shownInstead(), QStringLiteral("Every segment belongs to a plane."));
    model_->setMap(MadeMap().slice(0).finished(0).get());
    QCOMPARE(panel_->table()->shownInstead(), QStringLiteral("The scan has no line segments."));
}

}  // namespace planewright

PLANEWRIGHT_GUI_TEST(planewright::SegmentsPanelTest)
#include "segments_panel_test.moc"
