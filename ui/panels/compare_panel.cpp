// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/panels/compare_panel.h"

#include <algorithm>

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>

#include "core/types/angle.h"
#include "ui/models/number_text.h"
#include "ui/panels/filtered_table.h"

namespace planewright {

namespace {

using CompareKind = FilterKey::Kind;
constexpr std::array<FilterKey, 7> kCompareKeys{{
    {"what", CompareKind::Text, static_cast<int>(CompareColumn::What)},
    {"a", CompareKind::Text, static_cast<int>(CompareColumn::A)},
    {"b", CompareKind::Text, static_cast<int>(CompareColumn::B)},
    {"overlap", CompareKind::Number, static_cast<int>(CompareColumn::Overlap)},
    {"angle", CompareKind::Number, static_cast<int>(CompareColumn::Angle)},
    {"distance", CompareKind::Number, static_cast<int>(CompareColumn::Distance)},
    {"segments", CompareKind::Number, static_cast<int>(CompareColumn::SegmentsA)},
}};

constexpr int kSideWidth = 360;  // of the choice beside the table [px]

QString totalsRow(const QString& name, const Snapshot& map)
{
    const StepCounts& counts = map.report.counts;
    const auto cell = [](const QString& text) {
        return QStringLiteral("<td align=\"right\" style=\"padding-left:12px\">%1</td>").arg(text);
    };
    return QStringLiteral("<tr><td><b>%1</b></td>").arg(name.toHtmlEscaped()) + cell(QString::number(counts.planes)) +
           cell(QString::number(counts.fitted)) + cell(QString::number(counts.unfitted)) + cell(meanErrorText(counts)) +
           QStringLiteral("</tr>");
}

}  // namespace

ComparePanel::ComparePanel(CompareModel& model, QWidget* parent)
    : QWidget(parent),
      model_(model),
      choice_(new QComboBox(this)),
      run_(new QPushButton(tr("Compare"), this)),
      close_(new QPushButton(tr("Close"), this)),
      progress_(new QProgressBar(this)),
      meaning_(new QLabel(this)),
      totals_(new QLabel(this)),
      table_(new FilteredTable(&model, kCompareKeys,
                               {.objectName = QStringLiteral("compareTable"),
                                .accessibleName = tr("Planes of both extractions"),
                                .filterName = tr("Filter the planes of both extractions"),
                                .filterPlaceholder = tr("Filter: what:only angle>0.1"),
                                .emptyText = tr("Choose other parameters and press Compare: the scan is extracted once "
                                                "more beside itself.")},
                               {0, 1, 2, 3, 4, 5, 6, 7, 8, 9}, this))
{
    setObjectName(QStringLiteral("comparePanel"));
    choice_->setObjectName(QStringLiteral("compareWith"));
    choice_->setAccessibleName(tr("Parameters to compare with"));
    run_->setObjectName(QStringLiteral("compareRun"));
    run_->setToolTip(tr("Extract the scan once more with these parameters, and show both"));
    close_->setObjectName(QStringLiteral("compareClose"));
    close_->setToolTip(tr("Take the second view away"));
    progress_->setObjectName(QStringLiteral("compareProgress"));
    progress_->setAccessibleName(tr("Progress of the second extraction"));
    meaning_->setWordWrap(true);
    meaning_->setObjectName(QStringLiteral("compareMeaning"));
    totals_->setObjectName(QStringLiteral("compareTotals"));
    totals_->setTextFormat(Qt::RichText);

    auto* left = new QVBoxLayout;
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(choice_, 1);
    buttons->addWidget(run_);
    buttons->addWidget(close_);
    left->addLayout(buttons);
    left->addWidget(meaning_);
    left->addWidget(progress_);
    left->addWidget(totals_);
    left->addStretch(1);
    auto* side = new QWidget(this);
    side->setLayout(left);
    side->setFixedWidth(kSideWidth);
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins({});
    layout->addWidget(side);
    layout->addWidget(table_, 1);
    table_->view()->setEditTriggers(QAbstractItemView::NoEditTriggers);
    const QString number = QStringLiteral("000.00");
    table_->setWidths({tr("only A"), QStringLiteral("(P000)"), QStringLiteral("(P000)"), number, number, number, number,
                       number, number, number});

    connect(choice_, &QComboBox::currentIndexChanged, this,
            [this](int choice) { meaning_->setText(meanings_.value(choice)); });
    connect(run_, &QPushButton::clicked, this, [this] { emit runRequested(choice()); });
    connect(close_, &QPushButton::clicked, this, &ComparePanel::closeRequested);
    connect(table_, &FilteredTable::chosenChanged, this, &ComparePanel::choose);
    connect(&model_, &QAbstractItemModel::modelReset, this, &ComparePanel::updateFooter);
    setFocusProxy(choice_);
    setIdle(false);
}

void ComparePanel::setChoices(const QStringList& names, const QStringList& meanings)
{
    const QString before = choice_->currentText();
    meanings_ = meanings;
    choice_->clear();
    choice_->addItems(names);
    setChoice(static_cast<int>(std::max(names.indexOf(before), qsizetype{0})));
}

int ComparePanel::choice() const
{
    return choice_->currentIndex();
}

void ComparePanel::setChoice(int choice)
{
    choice_->setCurrentIndex(choice);
}

void ComparePanel::setNames(const QString& a, const QString& b)
{
    nameA_ = a;
    nameB_ = b;
}

void ComparePanel::setProgress(int steps, int all)
{
    progress_->setVisible(true);
    progress_->setRange(0, std::max(all, steps));
    progress_->setValue(steps);
    close_->setEnabled(true);
    close_->setText(tr("Cancel"));
    run_->setEnabled(false);
}

void ComparePanel::setIdle(bool hasBranch)
{
    progress_->setVisible(false);
    close_->setText(tr("Close"));
    close_->setEnabled(hasBranch);
    run_->setEnabled(true);
}

void ComparePanel::setTotals(const Snapshot* a, const Snapshot* b)
{
    if (a == nullptr || b == nullptr) {
        totals_->clear();
        return;
    }
    const auto head = [](const QString& text) {
        return QStringLiteral("<td align=\"right\" style=\"padding-left:12px\">%1</td>").arg(text);
    };
    totals_->setText(QStringLiteral("<table><tr><td></td>") + head(tr("planes")) + head(tr("fitted")) +
                     head(tr("unfitted")) + head(tr("mean E")) + QStringLiteral("</tr>") +
                     totalsRow(tr("A: %1").arg(nameA_), *a) + totalsRow(tr("B: %1").arg(nameB_), *b) +
                     QStringLiteral("</table>"));
}

void ComparePanel::choose()
{
    const std::vector<int> rows = table_->chosenRows();
    if (rows.size() == 1)
        emit planesChosen(model_.planeA(rows.front()), model_.planeB(rows.front()));
}

void ComparePanel::updateFooter()
{
    const MapComparison& comparison = model_.comparison();
    if (model_.rowCount() == 0) {
        table_->setFooter({});
        return;
    }
    table_->setFooter(
        tr("%1 in both, %2 only in A, %3 only in B; of both: angle median %4°, most %5°, Δd median %6 mm, "
           "most %7 mm")
            .arg(comparison.pairs.size())
            .arg(comparison.onlyA.size())
            .arg(comparison.onlyB.size())
            .arg(numberText(toDegrees(comparison.errors.angle.median), 3),
                 numberText(toDegrees(comparison.errors.angle.max), 3),
                 numberText(1000.0 * comparison.errors.distance.median, 1),
                 numberText(1000.0 * comparison.errors.distance.max, 1)));
}

}  // namespace planewright
