// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/dialogs/history_dialog.h"

#include <QDialogButtonBox>
#include <QListWidget>
#include <QPushButton>
#include <QVBoxLayout>

namespace planewright {

HistoryDialog::HistoryDialog(QWidget* parent) : QDialog(parent), lines_(new QListWidget(this))
{
    setObjectName(QStringLiteral("historyDialog"));
    setWindowTitle(tr("History"));
    resize(460, 420);
    lines_->setObjectName(QStringLiteral("historyLines"));
    lines_->setAccessibleName(tr("History"));
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    undo_ = buttons->addButton(tr("&Undo"), QDialogButtonBox::ActionRole);
    undo_->setObjectName(QStringLiteral("historyUndo"));
    redo_ = buttons->addButton(tr("&Redo"), QDialogButtonBox::ActionRole);
    redo_->setObjectName(QStringLiteral("historyRedo"));
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(lines_, 1);
    layout->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(undo_, &QPushButton::clicked, this, &HistoryDialog::undoRequested);
    connect(redo_, &QPushButton::clicked, this, &HistoryDialog::redoRequested);
}

void HistoryDialog::setLines(const std::vector<Line>& lines, bool canUndo, bool canRedo)
{
    lines_->clear();
    lines_->addItem(tr("The scan as it was extracted"));
    int last = 0;
    for (const Line& line : lines) {
        auto* item = new QListWidgetItem(line.isUndone ? tr("%1 (undone)").arg(line.text) : line.text, lines_);
        if (line.isUndone)
            item->setForeground(palette().placeholderText());
        else
            last = lines_->count() - 1;
    }
    lines_->setCurrentRow(last);
    undo_->setEnabled(canUndo);
    redo_->setEnabled(canRedo);
}

}  // namespace planewright
