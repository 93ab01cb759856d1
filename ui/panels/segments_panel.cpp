// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/panels/segments_panel.h"

#include <QCheckBox>
#include <QVBoxLayout>

#include "ui/models/number_text.h"
#include "ui/panels/filtered_table.h"

namespace planewright {

namespace {

const std::vector<int> kDefaultSegmentColumns{
    static_cast<int>(SegmentColumn::Id),      static_cast<int>(SegmentColumn::Step),
    static_cast<int>(SegmentColumn::State),   static_cast<int>(SegmentColumn::Plane),
    static_cast<int>(SegmentColumn::Cluster), static_cast<int>(SegmentColumn::Length),
    static_cast<int>(SegmentColumn::Points),  static_cast<int>(SegmentColumn::Rms)};

}  // namespace

SegmentsPanel::SegmentsPanel(SegmentsModel& model, MapSelection& selection, QWidget* parent)
    : QWidget(parent),
      model_(model),
      selection_(selection),
      table_(new FilteredTable(&model, segmentFilterKeys(),
                               {.objectName = QStringLiteral("segmentsTable"),
                                .accessibleName = tr("Line segments"),
                                .filterName = tr("Filter segments"),
                                .filterPlaceholder = tr("Filter: step>40 length<0.5"),
                                .emptyText = tr("No segments yet. They come with the first slice.")},
                               kDefaultSegmentColumns, this)),
      unfittedOnly_(new QCheckBox(tr("Unfitted only"), this))
{
    setObjectName(QStringLiteral("segmentsPanel"));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins({});
    layout->addWidget(table_);
    setFocusProxy(table_->view());
    unfittedOnly_->setObjectName(QStringLiteral("unfittedOnly"));
    unfittedOnly_->setAccessibleName(unfittedOnly_->text());
    unfittedOnly_->setToolTip(tr("Shows segments that belong to no plane"));
    table_->top()->addWidget(unfittedOnly_);
    table_->view()->setEditTriggers(QAbstractItemView::NoEditTriggers);
    const QString point = QStringLiteral("-00.00 -00.00 -00.00");
    table_->setWidths({QStringLiteral("1000.00"), QStringLiteral("1000"), QStringLiteral("unfitted"),
                       QStringLiteral("P000"), QStringLiteral("C000"), QStringLiteral("00.00"), QStringLiteral("0000"),
                       QStringLiteral("00.0"), point, point});

    connect(unfittedOnly_, &QCheckBox::toggled, this, [this](bool only) {
        sayWhyEmpty();
        table_->setRequirement(only ? QStringLiteral("state:unfitted") : QString{});
    });
    connect(table_, &FilteredTable::chosenChanged, this, &SegmentsPanel::giveSelection);
    connect(table_, &FilteredTable::rowsChanged, this, &SegmentsPanel::sumUp);
    connect(table_, &FilteredTable::filtered, this, &SegmentsPanel::takeSelection);
    connect(&selection_, &MapSelection::changed, this, &SegmentsPanel::takeSelection);
    connect(&model_, &SegmentsModel::mapChanged, this, &SegmentsPanel::sayWhyEmpty);
    sumUp();
}

void SegmentsPanel::showUnfittedOnly(bool only)
{
    unfittedOnly_->setChecked(only);
}

void SegmentsPanel::takeSelection()
{
    std::vector<int> rows;
    for (const SegmentId& segment : selection_.segments()) {
        if (const auto row = model_.rowOf(segment))
            rows.push_back(*row);
    }
    if (rows != table_->chosenRows()) {
        taking_ = true;
        table_->choose(rows);
        taking_ = false;
    }
}

void SegmentsPanel::giveSelection()
{
    if (taking_)
        return;
    std::set<SegmentId> segments;
    for (const int row : table_->chosenRows())
        segments.insert(model_.segmentAt(row));
    selection_.selectSegments(std::move(segments));
}

void SegmentsPanel::sayWhyEmpty()
{
    const bool isOver = model_.map() && model_.map()->finished;
    if (model_.rowCount() > 0 && unfittedOnly_->isChecked())
        table_->setEmptyText(tr("Every segment belongs to a plane."));
    else
        table_->setEmptyText(isOver ? tr("The scan has no line segments.")
                                    : tr("No segments yet. They come with the first slice."));
}

void SegmentsPanel::sumUp()
{
    const int seen = table_->rows()->rowCount();
    table_->setFooter(model_.rowCount() == 0 ? QString{}
                                             : tr("%1 of %2 shown, %3 unfitted")
                                                   .arg(seen)
                                                   .arg(countText(model_.rowCount(), tr("segment"), tr("segments")))
                                                   .arg(model_.unfitted()));
}

}  // namespace planewright
