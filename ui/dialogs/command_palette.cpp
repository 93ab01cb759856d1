// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/dialogs/command_palette.h"

#include <algorithm>

#include <QAction>
#include <QCoreApplication>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QVBoxLayout>

namespace planewright {

namespace {
constexpr QSize kSize{520, 360};    // [px]
constexpr int kCommandHeight = 28;  // [px]
}  // namespace

CommandPalette::CommandPalette(const QList<QAction*>& actions, QWidget* parent)
    : QDialog(parent),
      actions_(listedActions(actions)),
      query_(new QLineEdit(this)),
      list_(new QListWidget(this)),
      nothing_(new QLabel(tr("No command has these letters in this order."), this))
{
    setObjectName(QStringLiteral("commandPalette"));
    setWindowTitle(tr("Command palette"));
    resize(kSize);
    query_->setObjectName(QStringLiteral("commandQuery"));
    query_->setAccessibleName(tr("Command"));
    query_->setPlaceholderText(tr("Type some letters of a command"));
    list_->setObjectName(QStringLiteral("commandList"));
    list_->setAccessibleName(tr("Commands"));
    list_->setFocusPolicy(Qt::NoFocus);  // the keyboard stays in the line above
    list_->setUniformItemSizes(true);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(query_);
    layout->addWidget(list_, 1);
    layout->addWidget(nothing_);
    query_->installEventFilter(this);
    connect(query_, &QLineEdit::textChanged, this, &CommandPalette::fill);
    connect(query_, &QLineEdit::returnPressed, this, &CommandPalette::run);
    connect(list_, &QListWidget::itemClicked, this, &CommandPalette::run);
    fill();
}

void CommandPalette::fill()
{
    struct Hit {
        int fit;
        std::size_t place;
    };
    std::vector<Hit> hits;
    for (std::size_t i = 0; i < actions_.size(); ++i) {
        const int fit = std::max(fuzzyFit(query_->text(), actions_[i].text),
                                 fuzzyFit(query_->text(), actions_[i].group + ' ' + actions_[i].text));
        if (fit >= 0)
            hits.push_back({fit, i});
    }
    std::stable_sort(hits.begin(), hits.end(), [](const Hit& a, const Hit& b) { return a.fit > b.fit; });
    list_->clear();
    for (const Hit& hit : hits) {
        const ListedAction& listed = actions_[hit.place];
        QString text = listed.group.isEmpty() ? listed.text : listed.group + QStringLiteral(" › ") + listed.text;
        if (!listed.keys.isEmpty())
            text += QStringLiteral("    ") + listed.keys;
        auto* item = new QListWidgetItem(text, list_);
        item->setData(Qt::UserRole, static_cast<int>(hit.place));
        item->setSizeHint({0, std::max(kCommandHeight, fontMetrics().height() + 8)});
        if (!listed.action->isEnabled()) {
            item->setFlags(item->flags() & ~Qt::ItemIsEnabled);
            item->setToolTip(tr("Not possible now"));
        }
    }
    for (int row = 0; row < list_->count() && list_->currentRow() < 0; ++row) {
        if (list_->item(row)->flags().testFlag(Qt::ItemIsEnabled))
            list_->setCurrentRow(row);
    }
    nothing_->setVisible(hits.empty());
}

bool CommandPalette::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::KeyPress) {
        const int key = static_cast<QKeyEvent*>(event)->key();
        if (key == Qt::Key_Up || key == Qt::Key_Down || key == Qt::Key_PageUp || key == Qt::Key_PageDown) {
            QCoreApplication::sendEvent(list_, event);
            return true;
        }
    }
    return QDialog::eventFilter(watched, event);
}

void CommandPalette::run()
{
    const QListWidgetItem* item = list_->currentItem();
    if (item == nullptr || !item->flags().testFlag(Qt::ItemIsEnabled))
        return;
    QAction* action = actions_[static_cast<std::size_t>(item->data(Qt::UserRole).toInt())].action;
    accept();
    action->trigger();
}

}  // namespace planewright
