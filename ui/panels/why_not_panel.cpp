// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/panels/why_not_panel.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QSignalBlocker>
#include <QTableView>
#include <QVBoxLayout>

#include "core/types/plane_words.h"
#include "ui/panels/copy_rows.h"
#include "ui/panels/line_delegate.h"

namespace planewright {

namespace {

constexpr int kMarkWidth = 32;   // [px]
constexpr int kValueWidth = 84;  // [px]

QComboBox* makeBox(const QString& objectName, const QString& name)
{
    auto* box = new QComboBox;
    box->setObjectName(objectName);
    box->setAccessibleName(name);
    box->setToolTip(QObject::tr("A plane as P07, or a segment as 64.3: step and place in its slice"));
    box->setEditable(true);
    box->setInsertPolicy(QComboBox::NoInsert);
    box->setMinimumContentsLength(6);
    box->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    box->lineEdit()->setPlaceholderText(QObject::tr("P07 or 64.3"));
    return box;
}

/// "P07" as it stands in the boxes, or "64.3".
QString boxText(const Operand& operand)
{
    const auto* segment = std::get_if<SegmentId>(&operand);
    return segment != nullptr ? QString::fromStdString(segmentLabel(*segment)) : operandText(operand);
}

}  // namespace

WhyNotPanel::WhyNotPanel(QWidget* parent)
    : QWidget(parent),
      boxes_{makeBox(QStringLiteral("whyNotFirst"), tr("First plane or segment")),
             makeBox(QStringLiteral("whyNotSecond"), tr("Second plane or segment"))},
      sentence_(new QLabel(this)),
      table_(new QTableView(this))
{
    setObjectName(QStringLiteral("whyNotPanel"));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(6, 6, 6, 6);
    layout->setSpacing(6);
    auto* line = new QHBoxLayout;
    line->addWidget(boxes_[0], 1);
    line->addWidget(new QLabel(tr("and")));
    line->addWidget(boxes_[1], 1);
    layout->addLayout(line);
    sentence_->setObjectName(QStringLiteral("whyNotSentence"));
    sentence_->setAccessibleName(tr("Answer"));
    sentence_->setWordWrap(true);
    sentence_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    layout->addWidget(sentence_);
    makeTable();
    layout->addWidget(table_, 1);
    setFocusProxy(boxes_[0]);
    for (QComboBox* box : boxes_) {
        connect(box, &QComboBox::activated, this, &WhyNotPanel::asked);
        connect(box->lineEdit(), &QLineEdit::editingFinished, this, &WhyNotPanel::asked);
    }
    setProblem(tr("Choose two planes, or a segment and a plane: here, in the 3D view or in the tables."));
}

void WhyNotPanel::makeTable()
{
    table_->setObjectName(QStringLiteral("whyNotTable"));
    table_->setAccessibleName(tr("Conditions"));
    table_->setModel(&model_);
    table_->setItemDelegate(new LineDelegate(table_));
    table_->setSelectionBehavior(QAbstractItemView::SelectRows);
    table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table_->setTabKeyNavigation(false);
    table_->setShowGrid(false);
    table_->setWordWrap(true);
    table_->verticalHeader()->hide();
    table_->verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    QHeaderView* header = table_->horizontalHeader();
    header->setMinimumSectionSize(kMarkWidth);
    header->setSectionsClickable(false);
    header->setHighlightSections(false);
    header->setSectionResizeMode(QHeaderView::Fixed);
    header->setSectionResizeMode(static_cast<int>(WhyNotColumn::Condition), QHeaderView::Stretch);
    for (const WhyNotColumn column : {WhyNotColumn::Value, WhyNotColumn::Limit})
        header->resizeSection(static_cast<int>(column), kValueWidth);
    for (const WhyNotColumn column : {WhyNotColumn::Comparison, WhyNotColumn::Verdict})
        header->resizeSection(static_cast<int>(column), kMarkWidth);
    new CopyRows(table_, QStringLiteral("actCopyConditions"),
                 [this](const QModelIndexList& rows) { return model_.rowsAsText(rows); });
    connect(&model_, &QAbstractItemModel::modelReset, table_, [this] {
        table_->clearSpans();
        for (int row = 0; row < model_.rowCount(); ++row) {
            if (model_.isWay(row))
                table_->setSpan(row, 0, 1, kWhyNotColumns);
        }
    });
    connect(table_, &QAbstractItemView::activated, this, [this](const QModelIndex& index) {
        const std::string_view key = model_.parameterAt(index.row());
        if (!key.empty())
            emit parameterRequested(QString::fromUtf8(key.data(), static_cast<qsizetype>(key.size())));
    });
}

void WhyNotPanel::setPlanes(const std::vector<PlaneId>& planes)
{
    QStringList labels;
    for (const PlaneId plane : planes)
        labels << QString::fromStdString(planeLabel(plane));
    for (QComboBox* box : boxes_) {
        const QSignalBlocker quiet(box);
        const QString text = box->currentText();
        box->clear();
        box->addItems(labels);
        box->setEditText(text);
    }
}

void WhyNotPanel::setOperands(const Operand& first, const Operand& second)
{
    boxes_[0]->setEditText(boxText(first));
    boxes_[1]->setEditText(boxText(second));
}

std::optional<Operand> WhyNotPanel::first() const
{
    return operandOf(boxes_[0]->currentText());
}

std::optional<Operand> WhyNotPanel::second() const
{
    return operandOf(boxes_[1]->currentText());
}

void WhyNotPanel::setAnswer(WhyNot answer, const QString& step)
{
    sentence_->setText(tr("Step %1: %2").arg(step, whyNotAnswer(answer)));
    model_.setAnswer(std::move(answer));
    table_->show();
}

void WhyNotPanel::setProblem(const QString& text)
{
    sentence_->setText(text);
    model_.setAnswer(std::nullopt);
    table_->hide();
}

QString WhyNotPanel::sentence() const
{
    return sentence_->text();
}

void WhyNotPanel::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    emit shown();
}

}  // namespace planewright
