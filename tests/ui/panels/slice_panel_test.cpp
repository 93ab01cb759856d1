// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/panels/slice_panel.h"

#include <QApplication>
#include <QTableView>
#include <QToolButton>
#include <QtTest>

#include "tests/test_program.h"
#include "tests/ui/made_slice.h"
#include "tests/ui/view3d/reference_image.h"
#include "ui/panels/slice_view.h"
#include "ui/theme/theme.h"

namespace planewright {

class SlicePanelTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void init();
    void theSketchHasAllThatIsToBeSeen();
    void aClickSelectsTheSegment();
    void aClickOnADiscardedPieceFindsItInTheList();
    void aDiscardedPieceThatIsChosenElsewhereIsFoundInTheList();
    void aRowOfTheListSelectsItsSegment();
    void theSelectionIsMarkedInBoth();
    void theWheelZoomsToThePointer();
    void keysZoomPanAndFit();
    void aDragPansAndSelectsNothing();
    void whereThereIsNoRoomTheListTakesThePlaceOfTheDrawing();
    void everyControlHasANameAndASize();
    void withoutASliceItSaysSo();
    void slicesAreAsTheyWere_data();
    void slicesAreAsTheyWere();

private:
    /// The middle of a piece, in the view's pixels.
    QPoint middleOf(std::size_t piece) const
    {
        const TracedPiece& traced = sketch_->trace.pieces[piece];
        const SliceView& view = *panel_->view();
        return (0.5 *
                (view.pixelOf(sketch_->pointAt(traced.firstBeam)) + view.pixelOf(sketch_->pointAt(traced.lastBeam))))
            .toPoint();
    }
    std::size_t pieceOf(PieceFate fate) const
    {
        std::size_t piece = 0;
        while (piece < sketch_->trace.pieces.size() && sketch_->trace.pieces[piece].fate != fate)
            ++piece;
        return piece;
    }

    MapSelection selection_;
    std::shared_ptr<SliceSketch> sketch_;
    std::unique_ptr<SlicePanel> panel_;
};

void SlicePanelTest::initTestCase()
{
    QLocale::setDefault(QLocale::c());
    QFont font(QStringLiteral("DejaVu Sans"));
    font.setPixelSize(12);
    QApplication::setFont(font);
    applyTheme(Theme::Light);
}

void SlicePanelTest::init()
{
    panel_.reset();
    selection_.clear();
    sketch_ = madeSketch();
    panel_ = std::make_unique<SlicePanel>(selection_);
    panel_->resize(900, 300);
    panel_->setSketch(sketch_);
    panel_->show();
    QVERIFY(QTest::qWaitForWindowExposed(panel_.get()));
    panel_->view()->fit();
}

void SlicePanelTest::theSketchHasAllThatIsToBeSeen()
{
    QVERIFY(pieceOf(PieceFate::Segment) < sketch_->trace.pieces.size());
    QVERIFY(pieceOf(PieceFate::TooShort) < sketch_->trace.pieces.size());
    QVERIFY(!sketch_->trace.splits.empty());
    QVERIFY(sketch_->trace.breaks.size() >= 3);
    QVERIFY(panel_->summary().startsWith("Step 63, φ 81.9°: "));
}

void SlicePanelTest::aClickSelectsTheSegment()
{
    const std::size_t piece = pieceOf(PieceFate::Segment);

    QTest::mouseClick(panel_->view(), Qt::LeftButton, {}, middleOf(piece));

    QCOMPARE(selection_.segments(), (std::set<SegmentId>{{62, sketch_->trace.pieces[piece].segment}}));
    QVERIFY(selection_.planes().empty());

    QTest::mouseClick(panel_->view(), Qt::LeftButton, {}, QPoint(3, 3));
    QVERIFY(selection_.isEmpty());
}

void SlicePanelTest::aClickOnADiscardedPieceFindsItInTheList()
{
    const std::size_t piece = pieceOf(PieceFate::TooShort);
    panel_->view()->zoom(4.0, middleOf(piece));

    QTest::mouseClick(panel_->view(), Qt::LeftButton, {}, middleOf(piece));

    const TracedPiece& traced = sketch_->trace.pieces[piece];
    QVERIFY(selection_.segments().empty());
    QVERIFY(selection_.pieces() == (std::set<BeamRun>{{62, traced.firstBeam, traced.lastBeam}}));
    const QModelIndexList rows = panel_->list()->selectionModel()->selectedRows();
    QCOMPARE(rows.size(), 1);
    QCOMPARE(std::optional<int>(rows.front().row()), panel_->model().rowOf(SlicePart::Piece, piece));
}

void SlicePanelTest::aDiscardedPieceThatIsChosenElsewhereIsFoundInTheList()
{
    const std::size_t piece = pieceOf(PieceFate::TooShort);
    const TracedPiece& traced = sketch_->trace.pieces[piece];

    selection_.select({}, {}, {{62, traced.firstBeam, traced.lastBeam}});

    const QModelIndexList rows = panel_->list()->selectionModel()->selectedRows();
    QCOMPARE(rows.size(), 1);
    QCOMPARE(std::optional<int>(rows.front().row()), panel_->model().rowOf(SlicePart::Piece, piece));

    selection_.select({}, {}, {{61, traced.firstBeam, traced.lastBeam}});  // of another slice
    QVERIFY(panel_->list()->selectionModel()->selectedRows().isEmpty());
}

void SlicePanelTest::aRowOfTheListSelectsItsSegment()
{
    const auto row = panel_->model().rowOf(SegmentId{62, 1});
    QVERIFY(row);

    panel_->list()->selectRow(*row);

    QCOMPARE(selection_.segments(), (std::set<SegmentId>{{62, 1}}));
}

void SlicePanelTest::theSelectionIsMarkedInBoth()
{
    const QImage before = panel_->view()->grab().toImage();

    selection_.select({}, {{62, 1}, {3, 0}});

    const QModelIndexList rows = panel_->list()->selectionModel()->selectedRows();
    QCOMPARE(rows.size(), 1);
    QCOMPARE(std::optional<int>(rows.front().row()), panel_->model().rowOf(SegmentId{62, 1}));
    QVERIFY(panel_->view()->grab().toImage() != before);
}

void SlicePanelTest::theWheelZoomsToThePointer()
{
    SliceView& view = *panel_->view();
    const QPointF place(100.0, 60.0);
    const Eigen::Vector2d there = view.pointOf(place);
    const double before = view.pixelOf({1.0, 0.0}).x() - view.pixelOf({0.0, 0.0}).x();

    QWheelEvent wheel(place, view.mapToGlobal(place), {}, QPoint(0, 120), Qt::NoButton, Qt::NoModifier,
                      Qt::NoScrollPhase, false);
    QApplication::sendEvent(&view, &wheel);

    QVERIFY((view.pointOf(place) - there).norm() < 1e-9);
    const double after = view.pixelOf({1.0, 0.0}).x() - view.pixelOf({0.0, 0.0}).x();
    QVERIFY(std::abs(after / before - 1.25) < 1e-9);
}

void SlicePanelTest::keysZoomPanAndFit()
{
    SliceView& view = *panel_->view();
    const QPointF atFirst = view.pixelOf({1.0, 1.0});

    QTest::keyClick(&view, Qt::Key_Plus);
    QTest::keyClick(&view, Qt::Key_Left);
    const QPointF moved = view.pixelOf({1.0, 1.0});
    QVERIFY(moved != atFirst);
    QTest::keyClick(&view, Qt::Key_Right);
    QTest::keyClick(&view, Qt::Key_Minus);
    QVERIFY((view.pixelOf({1.0, 1.0}) - atFirst).manhattanLength() < 1e-6);

    QTest::keyClick(&view, Qt::Key_Up);
    QTest::keyClick(&view, Qt::Key_F);
    QVERIFY((view.pixelOf({1.0, 1.0}) - atFirst).manhattanLength() < 1e-6);
}

void SlicePanelTest::aDragPansAndSelectsNothing()
{
    SliceView& view = *panel_->view();
    const QPoint from = middleOf(pieceOf(PieceFate::Segment));
    const QPointF before = view.pixelOf({0.0, 0.0});

    QTest::mousePress(&view, Qt::LeftButton, {}, from);
    QTest::mouseMove(&view, from + QPoint(30, 20));
    QTest::mouseRelease(&view, Qt::LeftButton, {}, from + QPoint(30, 20));

    QVERIFY((view.pixelOf({0.0, 0.0}) - before - QPointF(30, 20)).manhattanLength() < 1e-6);
    QVERIFY(selection_.isEmpty());
}

void SlicePanelTest::whereThereIsNoRoomTheListTakesThePlaceOfTheDrawing()
{
    QVERIFY(panel_->view()->isVisible() && panel_->list()->isVisible());

    panel_->resize(310, 190);
    QTest::qWait(0);
    QVERIFY(panel_->view()->isVisible() && !panel_->list()->isVisible());

    QTest::mouseClick(panel_->findChild<QToolButton*>("sliceList"), Qt::LeftButton);
    QVERIFY(!panel_->view()->isVisible() && panel_->list()->isVisible());
}

void SlicePanelTest::everyControlHasANameAndASize()
{
    for (const char* name : {"sliceFit", "sliceList", "sliceView", "sliceTable"}) {
        auto* control = panel_->findChild<QWidget*>(name);
        QVERIFY2(control != nullptr, name);
        QVERIFY2(!control->accessibleName().isEmpty(), name);
        QVERIFY2(control->focusPolicy() & Qt::TabFocus, name);
        QVERIFY2(control->height() >= 28, name);
    }
    QCOMPARE(panel_->view()->accessibleDescription(), panel_->summary());
    QVERIFY(panel_->minimumSizeHint().width() <= 420);
}

void SlicePanelTest::withoutASliceItSaysSo()
{
    const QImage before = panel_->view()->grab().toImage();

    panel_->setSketch(nullptr);

    QVERIFY(panel_->summary().isEmpty());
    QCOMPARE(panel_->list()->model()->rowCount(), 0);
    QVERIFY(panel_->view()->grab().toImage() != before);
}

void SlicePanelTest::slicesAreAsTheyWere_data()
{
    QTest::addColumn<bool>("dark");
    QTest::newRow("slice-light") << false;
    QTest::newRow("slice-dark") << true;
}

void SlicePanelTest::slicesAreAsTheyWere()
{
    QFETCH(bool, dark);
    panel_.reset();
    applyTheme(dark ? Theme::Dark : Theme::Light);
    SlicePanel panel(selection_);
    panel.resize(960, 300);
    panel.setSketch(madeSketch(dark ? Theme::Dark : Theme::Light));
    panel.show();
    QVERIFY(QTest::qWaitForWindowExposed(&panel));
    selection_.select({}, {{62, 1}});
    QTest::qWait(20);

    const QString difference = differenceFromReference(panel.grab().toImage(), QTest::currentDataTag());

    applyTheme(Theme::Light);
    QVERIFY2(difference.isEmpty(), qPrintable(difference));
}

}  // namespace planewright

PLANEWRIGHT_GUI_TEST(planewright::SlicePanelTest)
#include "slice_panel_test.moc"
