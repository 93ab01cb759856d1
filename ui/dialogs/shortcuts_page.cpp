// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/dialogs/shortcuts_page.h"

#include <utility>

#include <QAction>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeySequenceEdit>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>

#include "ui/panels/problem_label.h"

namespace planewright {

namespace {

constexpr const char* kOwnKeys = "planewrightOwnKeys";

QList<QKeySequence> ownKeys(const QAction* action)
{
    const QVariant own = action->property(kOwnKeys);
    return own.isValid() ? own.value<QList<QKeySequence>>() : action->shortcuts();
}

/// The keys of an action by a map of changes.
QList<QKeySequence> keysBy(const ShortcutMap& changed, const QAction* action, const QSet<QString>& kept)
{
    const auto found = changed.find(action->objectName().toStdString());
    if (found == changed.end())
        return ownKeys(action);
    QList<QKeySequence> keys = kept.contains(action->objectName()) ? ownKeys(action) : QList<QKeySequence>{};
    for (const std::string& text : found->second) {
        const QKeySequence sequence(QString::fromStdString(text), QKeySequence::PortableText);
        if (!sequence.isEmpty() && !keys.contains(sequence))
            keys << sequence;
    }
    return keys;
}

}  // namespace

void rememberOwnKeys(const QList<QAction*>& actions)
{
    for (QAction* action : actions) {
        if (!action->property(kOwnKeys).isValid())
            action->setProperty(kOwnKeys, QVariant::fromValue(action->shortcuts()));
    }
}

void applyShortcuts(const QList<QAction*>& actions, const ShortcutMap& changed, const QSet<QString>& kept)
{
    for (QAction* action : actions)
        action->setShortcuts(keysBy(changed, action, kept));
}

ShortcutsPage::ShortcutsPage(const QList<QAction*>& actions, ShortcutMap changed, QSet<QString> kept, QWidget* parent)
    : QWidget(parent),
      actions_(listedActions(actions)),
      changed_(std::move(changed)),
      kept_(std::move(kept)),
      table_(new QTableWidget(static_cast<int>(actions_.size()), 2, this)),
      edit_(new QKeySequenceEdit(this)),
      problem_(new ProblemLabel(this))
{
    table_->setObjectName(QStringLiteral("shortcutTable"));
    table_->setAccessibleName(tr("Actions and their keys"));
    table_->setHorizontalHeaderLabels({tr("Action"), tr("Keys")});
    table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table_->setSelectionBehavior(QAbstractItemView::SelectRows);
    table_->setSelectionMode(QAbstractItemView::SingleSelection);
    table_->setTabKeyNavigation(false);
    table_->setShowGrid(false);
    table_->verticalHeader()->hide();
    table_->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
    edit_->setObjectName(QStringLiteral("shortcutKeys"));
    edit_->setAccessibleName(tr("New keys"));
    auto* set = new QPushButton(tr("Set keys"), this);
    set->setObjectName(QStringLiteral("setShortcut"));
    auto* own = new QPushButton(tr("Own keys"), this);
    own->setObjectName(QStringLiteral("ownShortcut"));
    own->setToolTip(tr("The keys that the action comes with"));
    auto* line = new QHBoxLayout;
    line->addWidget(edit_, 1);
    line->addWidget(set);
    line->addWidget(own);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins({});
    layout->addWidget(table_, 1);
    layout->addWidget(new QLabel(tr("Choose an action, press its new keys here, then set them."), this));
    layout->addLayout(line);
    layout->addWidget(problem_);
    connect(table_, &QTableWidget::itemSelectionChanged, this, &ShortcutsPage::showCurrent);
    connect(set, &QPushButton::clicked, this, &ShortcutsPage::take);
    connect(own, &QPushButton::clicked, this, [this] {
        if (table_->currentRow() < 0)
            return;
        changed_.erase(actions_[static_cast<std::size_t>(table_->currentRow())].action->objectName().toStdString());
        fill();
        showCurrent();
    });
    fill();
    table_->setCurrentCell(0, 0);
}

void ShortcutsPage::fill()
{
    for (int row = 0; row < table_->rowCount(); ++row) {
        const ListedAction& listed = actions_[static_cast<std::size_t>(row)];
        if (table_->item(row, 0) == nullptr) {
            const QString text =
                listed.group.isEmpty() ? listed.text : listed.group + QStringLiteral(" › ") + listed.text;
            table_->setItem(row, 0, new QTableWidgetItem(text));
            table_->setItem(row, 1, new QTableWidgetItem);
        }
        const bool isChanged = changed_.contains(listed.action->objectName().toStdString());
        QFont font = table_->font();
        font.setBold(isChanged);
        table_->item(row, 1)->setFont(font);
        table_->item(row, 1)->setText(
            QKeySequence::listToString(keysBy(changed_, listed.action, kept_), QKeySequence::NativeText));
    }
    table_->resizeColumnToContents(1);
}

void ShortcutsPage::showCurrent()
{
    problem_->tell({});
    edit_->clear();
}

QString ShortcutsPage::userOf(const QKeySequence& keys, const QString& except) const
{
    for (const ListedAction& listed : actions_) {
        if (listed.action->objectName() != except && keysBy(changed_, listed.action, kept_).contains(keys))
            return listed.text;
    }
    return {};
}

void ShortcutsPage::take()
{
    const int row = table_->currentRow();
    if (row < 0)
        return;
    const QString name = actions_[static_cast<std::size_t>(row)].action->objectName();
    const QKeySequence keys = edit_->keySequence();
    const QString user = keys.isEmpty() ? QString{} : userOf(keys, name);
    if (!user.isEmpty()) {
        problem_->tell(
            tr("%1 belongs to “%2”. Give that other keys first.").arg(keys.toString(QKeySequence::NativeText), user));
        return;
    }
    std::vector<std::string>& chosen = changed_[name.toStdString()];
    chosen.clear();
    if (!keys.isEmpty())
        chosen.push_back(keys.toString(QKeySequence::PortableText).toStdString());
    fill();
    showCurrent();
}

void ShortcutsPage::restoreDefaults()
{
    changed_.clear();
    fill();
    showCurrent();
}

int ShortcutsPage::search(const QString& words)
{
    int left = 0;
    for (int row = 0; row < table_->rowCount(); ++row) {
        const bool found = table_->item(row, 0)->text().contains(words, Qt::CaseInsensitive) ||
                           table_->item(row, 1)->text().contains(words, Qt::CaseInsensitive);
        table_->setRowHidden(row, !found);
        left += found ? 1 : 0;
    }
    return left;
}

}  // namespace planewright
