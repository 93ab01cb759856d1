// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/panels/lineage_panel.h"

#include <QHeaderView>
#include <QLabel>
#include <QSplitter>
#include <QStackedWidget>
#include <QTableView>
#include <QVBoxLayout>

#include "ui/panels/copy_rows.h"

namespace planewright {

namespace {
constexpr int kLifeRowHeight = 28;  // [px]
}

LineagePanel::LineagePanel(QWidget* parent)
    : QWidget(parent),
      view_(new LineageView),
      table_(new QTableView),
      stack_(new QStackedWidget(this)),
      instead_(new QLabel(tr("Select a plane to see where it comes from and what becomes of it.")))
{
    setObjectName(QStringLiteral("lineagePanel"));
    instead_->setAlignment(Qt::AlignCenter);
    instead_->setWordWrap(true);
    instead_->setObjectName(QStringLiteral("lineageEmpty"));
    auto* both = new QSplitter(Qt::Vertical);
    both->setObjectName(QStringLiteral("lineageSplitter"));
    both->setChildrenCollapsible(false);
    both->addWidget(view_);
    makeTable();
    both->addWidget(table_);
    both->setStretchFactor(0, 3);
    both->setStretchFactor(1, 2);
    stack_->addWidget(instead_);
    stack_->addWidget(both);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(6, 6, 6, 6);
    layout->addWidget(stack_);
    setFocusProxy(view_);
    connect(view_, &LineageView::planeChosen, this, [this](PlaneId plane, int step) {
        chooseRow(std::nullopt);
        emit planeChosen(plane, step);
    });
    connect(view_, &LineageView::eventChosen, this, &LineagePanel::choose);
}

void LineagePanel::makeTable()
{
    table_->setObjectName(QStringLiteral("lifeEvents"));
    table_->setAccessibleName(tr("Events"));
    table_->setModel(&model_);
    table_->setSelectionBehavior(QAbstractItemView::SelectRows);
    table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table_->setTabKeyNavigation(false);
    table_->setShowGrid(false);
    table_->setMinimumHeight(2 * kLifeRowHeight);
    table_->verticalHeader()->hide();
    table_->verticalHeader()->setDefaultSectionSize(kLifeRowHeight);
    QHeaderView* header = table_->horizontalHeader();
    header->setSectionsClickable(false);
    header->setHighlightSections(false);
    header->setSectionResizeMode(QHeaderView::ResizeToContents);
    header->setSectionResizeMode(1, QHeaderView::Stretch);
    new CopyRows(table_, QStringLiteral("actCopyEvents"),
                 [this](const QModelIndexList& rows) { return model_.rowsAsText(rows); });
    connect(table_->selectionModel(), &QItemSelectionModel::currentRowChanged, this, [this](const QModelIndex& row) {
        if (choosing_ || !row.isValid())
            return;
        view_->setCurrentEvent(static_cast<std::size_t>(row.row()));
        choose(static_cast<std::size_t>(row.row()));
    });
}

void LineagePanel::setChart(LineageChart chart)
{
    stack_->setCurrentIndex(chart.bars.empty() ? 0 : 1);
    choosing_ = true;
    model_.setEvents(chart.events);
    choosing_ = false;
    view_->setChart(std::move(chart));
    chooseRow(view_->currentEvent());
}

void LineagePanel::setStep(int step, bool isThere)
{
    view_->setPlayhead(isThere ? view_->chart().momentOf(step) : -1);
}

QString LineagePanel::shownInstead() const
{
    return stack_->currentWidget() == instead_ ? instead_->text() : QString{};
}

void LineagePanel::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    emit shown();
}

void LineagePanel::choose(std::size_t event)
{
    chooseRow(event);
    const FamilyEvent& happened = view_->chart().events[event];
    emit planeChosen(happened.plane, happened.step);
}

void LineagePanel::chooseRow(std::optional<std::size_t> event)
{
    choosing_ = true;
    if (event && static_cast<int>(*event) < model_.rowCount())
        table_->selectRow(static_cast<int>(*event));
    else
        table_->clearSelection();
    choosing_ = false;
}

}  // namespace planewright
