// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/panels/measure_panel.h"

#include <algorithm>
#include <array>

#include <QAction>
#include <QHBoxLayout>
#include <QToolButton>
#include <QVBoxLayout>

#include "ui/panels/filtered_table.h"

namespace planewright {

namespace {

using Kind = FilterKey::Kind;
constexpr std::array<FilterKey, 3> kKeys{{
    {"distance", Kind::Number, static_cast<int>(MeasurementColumn::Distance)},
    {"angle", Kind::Number, static_cast<int>(MeasurementColumn::Angle)},
    {"step", Kind::Number, static_cast<int>(MeasurementColumn::Step)},
}};

QToolButton* buttonFor(QAction* action, QWidget* parent)
{
    auto* button = new QToolButton(parent);
    button->setDefaultAction(action);
    button->setToolButtonStyle(Qt::ToolButtonTextOnly);
    button->setObjectName(action->objectName() + QStringLiteral("Button"));
    button->setAccessibleName(action->iconText());
    return button;
}

}  // namespace

MeasurePanel::MeasurePanel(MeasurementsModel& model, QWidget* parent)
    : QWidget(parent),
      model_(model),
      table_(new FilteredTable(&model, kKeys,
                               {.objectName = QStringLiteral("measurementsTable"),
                                .accessibleName = tr("Measurements"),
                                .filterName = tr("Filter measurements"),
                                .filterPlaceholder = tr("Filter: distance>1 P03"),
                                .emptyText = tr("Press D and click two points.")},
                               {0, 1, 2, 3, 4, 5, 6}, this)),
      remove_(new QAction(tr("Remove"), this))
{
    setObjectName(QStringLiteral("measurePanel"));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins({});
    layout->addWidget(table_);
    setFocusProxy(table_->view());
    remove_->setObjectName(QStringLiteral("actRemoveMeasurement"));
    remove_->setEnabled(false);
    table_->addTableAction(remove_, QKeySequence::Delete);
    table_->view()->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table_->view()->sortByColumn(-1, Qt::AscendingOrder);  // as they were taken
    const QString length = QStringLiteral("-00.00");
    table_->setWidths({QStringLiteral("Angle of three points"), length, QStringLiteral("000.0"), length, length, length,
                       QStringLiteral("0000")});
    table_->top()->addWidget(buttonFor(remove_, this), 0, Qt::AlignTop);
    table_->top()->addWidget(buttonFor(table_->copyAction(), this), 0, Qt::AlignTop);

    const auto enable = [this] {
        remove_->setEnabled(!table_->chosenRows().empty());
        table_->copyAction()->setEnabled(table_->rows()->rowCount() > 0);
    };
    connect(remove_, &QAction::triggered, this, &MeasurePanel::removeChosen);
    connect(table_, &FilteredTable::chosenChanged, this, enable);
    connect(table_, &FilteredTable::rowsChanged, this, enable);
    enable();
}

void MeasurePanel::removeChosen()
{
    std::vector<int> rows = table_->chosenRows();
    std::reverse(rows.begin(), rows.end());  // the last first, so that the others keep their places
    for (const int row : rows)
        model_.remove(row);
}

}  // namespace planewright
