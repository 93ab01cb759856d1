// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/panels/slice_panel.h"

#include <utility>

#include <QHeaderView>
#include <QLabel>
#include <QScopedValueRollback>
#include <QTableView>
#include <QToolButton>
#include <QVBoxLayout>

#include "ui/panels/slice_view.h"

namespace planewright {

namespace {

constexpr int kRoomForBoth = 620;    // [px]
constexpr int kSliceRowHeight = 28;  // [px]

QToolButton* sliceButton(const char* name, const QString& text, const QString& tip)
{
    auto* button = new QToolButton;
    button->setObjectName(QLatin1String(name));
    button->setText(text);
    button->setAccessibleName(text);
    button->setToolTip(tip);
    button->setMinimumHeight(28);
    button->setFocusPolicy(Qt::StrongFocus);
    return button;
}

}  // namespace

SlicePanel::SlicePanel(MapSelection& selection, QWidget* parent)
    : QWidget(parent),
      selection_(selection),
      summary_(new QLabel),
      listButton_(sliceButton("sliceList", tr("List"), tr("What the segmentation did, as a list with the reasons"))),
      view_(new SliceView(model_)),
      list_(new QTableView)
{
    setObjectName(QStringLiteral("slicePanel"));
    setAccessibleName(tr("Slice 2D"));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(2, 2, 2, 0);
    layout->setSpacing(2);
    auto* top = new QHBoxLayout;
    top->setSpacing(4);
    layout->addLayout(top);
    summary_->setObjectName(QStringLiteral("sliceSummary"));
    summary_->setTextFormat(Qt::PlainText);
    summary_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    top->addWidget(summary_, 1);
    auto* fit = sliceButton("sliceFit", tr("Fit"), tr("Show all of the slice (F)"));
    top->addWidget(fit);
    listButton_->setCheckable(true);
    listButton_->setChecked(true);
    top->addWidget(listButton_);
    auto* both = new QHBoxLayout;
    both->setSpacing(2);
    layout->addLayout(both, 1);
    both->addWidget(view_, 1);
    both->addWidget(list_, 1);

    list_->setObjectName(QStringLiteral("sliceTable"));
    list_->setAccessibleName(tr("What the segmentation did"));
    list_->setModel(&model_);
    list_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    list_->setSelectionBehavior(QAbstractItemView::SelectRows);
    list_->setSelectionMode(QAbstractItemView::ExtendedSelection);
    list_->setTabKeyNavigation(false);
    list_->setAlternatingRowColors(true);
    list_->setMinimumWidth(200);
    list_->verticalHeader()->hide();
    list_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    list_->horizontalHeader()->moveSection(static_cast<int>(SliceColumn::Why), 1);
    list_->setWordWrap(false);
    list_->verticalHeader()->setDefaultSectionSize(kSliceRowHeight);
    list_->setColumnHidden(static_cast<int>(SliceColumn::Beams), true);

    connect(fit, &QToolButton::clicked, view_, &SliceView::fit);
    connect(listButton_, &QToolButton::toggled, this, &SlicePanel::arrange);
    connect(view_, &SliceView::rowChosen, this, &SlicePanel::take);
    connect(list_->selectionModel(), &QItemSelectionModel::selectionChanged, this, &SlicePanel::giveRow);
    connect(&selection_, &MapSelection::changed, this, &SlicePanel::takeSelection);
}

void SlicePanel::setSketch(std::shared_ptr<const SliceSketch> sketch)
{
    {
        const QScopedValueRollback taking(taking_, true);
        model_.setSketch(std::move(sketch));
    }
    summary_->setText(model_.summary());
    summary_->setToolTip(model_.summary());
    takeSelection();
}

QString SlicePanel::summary() const
{
    return summary_->text();
}

void SlicePanel::showList(bool shown)
{
    listButton_->setChecked(shown);
}

void SlicePanel::arrange()
{
    const bool list = listButton_->isChecked();
    list_->setVisible(list);
    view_->setVisible(!(list && isNarrow_));
}

/// The drawing was clicked.
void SlicePanel::take(int row, bool add)
{
    const auto segment = row < 0 ? std::nullopt : model_.segmentAt(row);
    const auto discarded = row < 0 ? std::nullopt : model_.discardedAt(row);
    if (segment && add)
        selection_.toggleSegment(*segment);
    else if (segment)
        selection_.select({}, {*segment});
    else if (discarded)
        selection_.select({}, {}, {*discarded});
    else if (!add)
        selection_.clear();
    view_->setRow(segment ? -1 : row);
    if (row < 0 || segment)
        return;
    const QScopedValueRollback taking(taking_, true);
    list_->selectRow(row);
}

void SlicePanel::takeSelection()
{
    view_->setSelected(selection_.segments());
    QItemSelection rows;
    for (const SegmentId& segment : selection_.segments()) {
        if (const auto row = model_.rowOf(segment))
            rows.select(model_.index(*row, 0), model_.index(*row, kSliceColumns - 1));
    }
    int discarded = -1;
    for (const BeamRun& piece : selection_.pieces()) {
        if (const auto row = model_.rowOf(piece)) {
            rows.select(model_.index(*row, 0), model_.index(*row, kSliceColumns - 1));
            discarded = *row;
        }
    }
    view_->setRow(discarded);
    const QScopedValueRollback taking(taking_, true);
    list_->selectionModel()->select(rows, QItemSelectionModel::ClearAndSelect);
    if (!rows.isEmpty())
        list_->scrollTo(rows.front().topLeft());
}

/// Rows of the list were chosen.
void SlicePanel::giveRow()
{
    if (taking_)
        return;
    std::set<SegmentId> segments;
    std::set<BeamRun> pieces;
    int other = -1;
    for (const QModelIndex& index : list_->selectionModel()->selectedRows()) {
        if (const auto segment = model_.segmentAt(index.row()))
            segments.insert(*segment);
        else
            other = index.row();
        if (const auto discarded = model_.discardedAt(index.row()))
            pieces.insert(*discarded);
    }
    if (segments.empty() && other < 0) {
        view_->setRow(-1);
        return;
    }
    const QScopedValueRollback taking(taking_, true);
    const QItemSelection rows = list_->selectionModel()->selection();
    selection_.select({}, std::move(segments), std::move(pieces));
    view_->setRow(other);
    list_->selectionModel()->select(rows, QItemSelectionModel::ClearAndSelect);
}

void SlicePanel::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    const bool narrow = width() < kRoomForBoth;
    if (narrow != isNarrow_) {
        isNarrow_ = narrow;
        listButton_->setChecked(!narrow);
        arrange();
    }
}

void SlicePanel::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange && isVisible())
        emit shown();
}

void SlicePanel::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    emit shown();
}

}  // namespace planewright
