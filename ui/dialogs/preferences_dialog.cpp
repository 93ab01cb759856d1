// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/dialogs/preferences_dialog.h"

#include <algorithm>
#include <utility>

#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QStackedWidget>
#include <QVBoxLayout>

#include "ui/dialogs/preferences_pages.h"
#include "ui/dialogs/shortcuts_page.h"

namespace planewright {

namespace {
constexpr int kListWidth = 140;     // [px]
constexpr int kPageRowHeight = 32;  // [px]
}  // namespace

PreferencesDialog::PreferencesDialog(Preferences preferences, const PreferencesContext& context, QWidget* parent)
    : QDialog(parent),
      loaded_(std::move(preferences)),
      list_(new QListWidget(this)),
      stack_(new QStackedWidget(this)),
      nothing_(new QLabel(tr("No preference has these words."), this))
{
    setObjectName(QStringLiteral("preferencesDialog"));
    setWindowTitle(tr("Preferences"));
    resize(720, 480);
    auto* search = new QLineEdit(this);
    search->setObjectName(QStringLiteral("preferencesSearch"));
    search->setAccessibleName(tr("Search preferences"));
    search->setPlaceholderText(tr("Search preferences"));
    search->setClearButtonEnabled(true);
    list_->setObjectName(QStringLiteral("preferencesPages"));
    list_->setAccessibleName(tr("Pages"));
    list_->setFixedWidth(kListWidth);
    nothing_->hide();
    auto* buttons = new QDialogButtonBox(
        QDialogButtonBox::Ok | QDialogButtonBox::Cancel | QDialogButtonBox::Apply | QDialogButtonBox::RestoreDefaults,
        this);
    QPushButton* restore = buttons->button(QDialogButtonBox::RestoreDefaults);
    restore->setObjectName(QStringLiteral("restoreDefaults"));
    restore->setText(tr("Restore defaults"));
    restore->setToolTip(tr("Of this page"));

    addPage(makeGeneralPage(this));
    addPage(makeViewPage(this));
    addPage(makeScanPage(context.presets, this));
    addShortcuts(context);
    addPage(makeAdvancedPage(context.advancedActions, this));

    auto* middle = new QHBoxLayout;
    middle->addWidget(list_);
    middle->addWidget(stack_, 1);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(search);
    layout->addWidget(nothing_);
    layout->addLayout(middle, 1);
    layout->addWidget(buttons);
    connect(list_, &QListWidget::currentRowChanged, stack_, &QStackedWidget::setCurrentIndex);
    connect(search, &QLineEdit::textChanged, this, &PreferencesDialog::search);
    connect(restore, &QPushButton::clicked, this, &PreferencesDialog::restoreDefaults);
    connect(buttons->button(QDialogButtonBox::Apply), &QPushButton::clicked, this,
            [this] { emit applied(this->preferences()); });
    connect(buttons, &QDialogButtonBox::accepted, this, [this] {
        emit applied(this->preferences());
        accept();
    });
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    list_->setCurrentRow(0);
}

void PreferencesDialog::addTab(QWidget* page, const QString& title)
{
    auto* item = new QListWidgetItem(title, list_);
    item->setSizeHint({0, std::max(kPageRowHeight, fontMetrics().height() + 12)});
    stack_->addWidget(page);
}

void PreferencesDialog::addPage(PreferencesPage* page)
{
    page->load(loaded_);
    pages_.push_back(page);
    addTab(page, page->title());
}

void PreferencesDialog::addShortcuts(const PreferencesContext& context)
{
    shortcuts_ = new ShortcutsPage(context.actions, loaded_.shortcuts, context.keptShortcuts, this);
    addTab(shortcuts_, tr("Shortcuts"));
}

Preferences PreferencesDialog::preferences() const
{
    Preferences current = loaded_;
    for (const PreferencesPage* page : pages_)
        page->store(current);
    current.shortcuts = shortcuts_->changed();
    return validated(std::move(current));
}

void PreferencesDialog::search(const QString& words)
{
    int first = -1;
    bool currentFits = false;
    for (int row = 0; row < stack_->count(); ++row) {
        auto* page = qobject_cast<PreferencesPage*>(stack_->widget(row));
        const int found = page != nullptr ? page->search(words) : shortcuts_->search(words);
        const bool fits = found > 0 || words.isEmpty();
        list_->item(row)->setHidden(!fits);
        if (fits && first < 0)
            first = row;
        currentFits = currentFits || (fits && row == list_->currentRow());
    }
    nothing_->setVisible(first < 0);
    if (!currentFits && first >= 0)
        list_->setCurrentRow(first);
}

void PreferencesDialog::restoreDefaults()
{
    if (auto* page = qobject_cast<PreferencesPage*>(stack_->currentWidget()))
        page->load(Preferences{});
    else
        shortcuts_->restoreDefaults();
}

}  // namespace planewright
