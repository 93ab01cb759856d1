// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/dialogs/shortcuts_dialog.h"

#include <QDialogButtonBox>
#include <QHeaderView>
#include <QLineEdit>
#include <QTableWidget>
#include <QVBoxLayout>

#include "ui/dialogs/action_list.h"

namespace planewright {

ShortcutsDialog::ShortcutsDialog(const QList<QAction*>& actions, QWidget* parent) : QDialog(parent)
{
    setObjectName(QStringLiteral("shortcutsDialog"));
    setWindowTitle(tr("Shortcuts"));
    resize(520, 560);
    const std::vector<ListedAction> listed = listedActions(actions);
    auto* search = new QLineEdit(this);
    search->setObjectName(QStringLiteral("shortcutSearch"));
    search->setAccessibleName(tr("Search"));
    search->setPlaceholderText(tr("Search"));
    search->setClearButtonEnabled(true);
    auto* table = new QTableWidget(static_cast<int>(listed.size()), 3, this);
    table->setObjectName(QStringLiteral("shortcutTable"));
    table->setAccessibleName(tr("Shortcuts"));
    table->setHorizontalHeaderLabels({tr("Menu"), tr("Action"), tr("Keys")});
    table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table->setSelectionBehavior(QAbstractItemView::SelectRows);
    table->setTabKeyNavigation(false);
    table->setShowGrid(false);
    table->setAlternatingRowColors(true);
    table->verticalHeader()->hide();
    for (int row = 0; row < table->rowCount(); ++row) {
        const ListedAction& action = listed[static_cast<std::size_t>(row)];
        table->setItem(row, 0, new QTableWidgetItem(action.group));
        table->setItem(row, 1, new QTableWidgetItem(action.text));
        table->setItem(row, 2, new QTableWidgetItem(action.keys));
    }
    table->resizeColumnsToContents();
    table->horizontalHeader()->setStretchLastSection(true);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(search);
    layout->addWidget(table, 1);
    layout->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(search, &QLineEdit::textChanged, this, [table](const QString& words) {
        for (int row = 0; row < table->rowCount(); ++row) {
            bool found = false;
            for (int column = 0; column < table->columnCount(); ++column)
                found = found || table->item(row, column)->text().contains(words, Qt::CaseInsensitive);
            table->setRowHidden(row, !found);
        }
    });
}

}  // namespace planewright
