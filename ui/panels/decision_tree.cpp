// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/panels/decision_tree.h"

#include <QHeaderView>
#include <QMouseEvent>

#include "ui/panels/copy_rows.h"
#include "ui/panels/line_delegate.h"

namespace planewright {

namespace {
constexpr int kIndentation = 16;  // [px]
}

DecisionTree::DecisionTree(DecisionsModel& model, QWidget* parent)
    : QTreeView(parent), model_(model), delegate_(new LineDelegate(this))
{
    setObjectName(QStringLiteral("decisionTree"));
    setAccessibleName(tr("Decisions of the step"));
    setToolTip({});
    setModel(&model);
    setItemDelegate(delegate_);
    setHeaderHidden(true);
    setIndentation(kIndentation);
    setSelectionMode(ExtendedSelection);
    setUniformRowHeights(false);
    // Heights are worked out for what is in view alone.
    setVerticalScrollMode(ScrollPerItem);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setExpandsOnDoubleClick(false);
    setAllColumnsShowFocus(true);
    setMouseTracking(true);
    setTextElideMode(Qt::ElideNone);
    header()->setStretchLastSection(true);
    header()->setMinimumSectionSize(0);
    for (const Phase phase : {Phase::Fit, Phase::SplitMerge})
        open_.insert({static_cast<int>(phase), {}});

    new CopyRows(this, QStringLiteral("actCopyDecisions"),
                 [this](const QModelIndexList& rows) { return model_.rowsAsText(rows); });
    connect(this, &QTreeView::activated, this, &DecisionTree::rowActivated);
    connect(this, &QTreeView::expanded, this, [this](const QModelIndex& index) { keepOpen(index, true); });
    connect(this, &QTreeView::collapsed, this, [this](const QModelIndex& index) { keepOpen(index, false); });
    connect(&model_, &QAbstractItemModel::modelAboutToBeReset, this, [this] {
        const InspectedPhase* phase = model_.phaseAt(currentIndex());
        current_ = phase == nullptr ? std::nullopt : std::optional(keyOf(*phase));
    });
    connect(&model_, &QAbstractItemModel::modelReset, this, &DecisionTree::openAgain);
}

DecisionTree::PhaseKey DecisionTree::keyOf(const InspectedPhase& phase) const
{
    return {static_cast<int>(phase.phase),
            QString::fromUtf8(phase.pass.data(), static_cast<qsizetype>(phase.pass.size()))};
}

void DecisionTree::keepOpen(const QModelIndex& index, bool open)
{
    if (opening_ || index.parent().isValid())
        return;
    const PhaseKey key = keyOf(*model_.phaseAt(index));
    if (open)
        open_.insert(key);
    else
        open_.erase(key);
}

void DecisionTree::openAgain()
{
    opening_ = true;
    for (int row = 0; row < model_.rowCount(); ++row) {
        const QModelIndex index = model_.index(row, 0);
        const PhaseKey key = keyOf(*model_.phaseAt(index));
        if (open_.contains(key))
            expand(index);
        if (current_ == key && !currentIndex().isValid())
            selectionModel()->setCurrentIndex(index, QItemSelectionModel::NoUpdate);
    }
    opening_ = false;
}

void DecisionTree::showPhase(std::size_t number)
{
    const QModelIndex index = model_.indexOfPhase(number);
    if (!index.isValid())
        return;
    opening_ = true;  // shown once is not opened for good
    expand(index);
    opening_ = false;
    selectionModel()->setCurrentIndex(index, QItemSelectionModel::NoUpdate);
    scrollTo(index, PositionAtTop);
}

void DecisionTree::resizeEvent(QResizeEvent* event)
{
    QTreeView::resizeEvent(event);
    // Another width breaks the lines elsewhere.
    if (event->size().width() != event->oldSize().width())
        scheduleDelayedItemsLayout();
}

bool DecisionTree::isOverLink(const QPoint& place) const
{
    const QModelIndex index = indexAt(place);
    if (!index.isValid() || model_.parameterAt(index).empty())
        return false;
    QStyleOptionViewItem option;
    initViewItemOption(&option);
    option.rect = visualRect(index);
    return delegate_->toneAt(option, index, place) == TextTone::Link;
}

void DecisionTree::mouseReleaseEvent(QMouseEvent* event)
{
    QTreeView::mouseReleaseEvent(event);
    const QPoint place = event->position().toPoint();
    if (event->button() == Qt::LeftButton && isOverLink(place))
        emit rowActivated(indexAt(place));
}

void DecisionTree::mouseMoveEvent(QMouseEvent* event)
{
    QTreeView::mouseMoveEvent(event);
    viewport()->setCursor(isOverLink(event->position().toPoint()) ? Qt::PointingHandCursor : Qt::ArrowCursor);
}

}  // namespace planewright
