// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/dialogs/preferences_page.h"

#include <utility>

#include <QCheckBox>
#include <QComboBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>

#include "ui/panels/plain_fields.h"

namespace planewright {

PreferencesPage::PreferencesPage(QString title, QWidget* parent)
    : QWidget(parent), title_(std::move(title)), form_(new QFormLayout(this))
{
    form_->setContentsMargins(12, 8, 12, 8);
    form_->setHorizontalSpacing(16);
    form_->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    form_->setLabelAlignment(Qt::AlignLeft);
}

void PreferencesPage::add(const QString& label, const QString& name, QWidget* widget,
                          std::function<void(const Preferences&)> load, std::function<void(Preferences&)> store)
{
    widget->setObjectName(name);
    widget->setAccessibleName(label);
    fields_.push_back({label, widget, std::move(load), std::move(store)});
    form_->addRow(label, widget);
}

void PreferencesPage::addIndex(const QString& label, const QString& name, const QStringList& words,
                               std::function<int(const Preferences&)> get, std::function<void(Preferences&, int)> set)
{
    auto* box = new QuietComboBox(this);
    box->addItems(words);
    add(
        label, name, box, [box, get = std::move(get)](const Preferences& p) { box->setCurrentIndex(get(p)); },
        [box, set = std::move(set)](Preferences& p) { set(p, box->currentIndex()); });
}

void PreferencesPage::addToggle(const QString& label, const QString& name, bool Preferences::*member)
{
    auto* box = new QCheckBox(this);
    add(
        label, name, box, [box, member](const Preferences& p) { box->setChecked(p.*member); },
        [box, member](Preferences& p) { p.*member = box->isChecked(); });
}

void PreferencesPage::addNumber(const QString& label, const QString& name, const QString& unit, double lowest,
                                double highest, int decimals, double Preferences::*member)
{
    auto* box = new PlainSpinBox(this);
    box->setDecimals(decimals);
    box->setRange(lowest, highest);
    box->setSuffix(' ' + unit);
    add(
        label, name, box, [box, member](const Preferences& p) { box->setValue(p.*member); },
        [box, member](Preferences& p) { p.*member = box->value(); });
}

void PreferencesPage::addFolder(const QString& label, const QString& name, const QString& placeholder,
                                std::string Preferences::*member)
{
    auto* holder = new QWidget(this);
    auto* edit = new QLineEdit(holder);
    edit->setObjectName(name + QStringLiteral("Path"));
    edit->setAccessibleName(label);
    edit->setPlaceholderText(placeholder);
    auto* browse = new QPushButton(tr("Browse…"), holder);
    browse->setObjectName(name + QStringLiteral("Browse"));
    browse->setAccessibleName(tr("Browse for: %1").arg(label));
    auto* line = new QHBoxLayout(holder);
    line->setContentsMargins({});
    line->addWidget(edit, 1);
    line->addWidget(browse);
    holder->setFocusProxy(edit);
    connect(browse, &QPushButton::clicked, edit, [this, edit, label] {
        const QString folder = QFileDialog::getExistingDirectory(this, label, edit->text());
        if (!folder.isEmpty())
            edit->setText(folder);
    });
    add(
        label, name, holder, [edit, member](const Preferences& p) { edit->setText(QString::fromStdString(p.*member)); },
        [edit, member](Preferences& p) { p.*member = edit->text().trimmed().toStdString(); });
}

void PreferencesPage::addWord(const QString& label, const QString& name, const QStringList& words,
                              std::string Preferences::*member)
{
    auto* box = new QuietComboBox(this);
    box->addItems(words);
    add(
        label, name, box,
        [box, member](const Preferences& p) {
            const QString word = QString::fromStdString(p.*member);
            if (box->findText(word) < 0)
                box->addItem(word);
            box->setCurrentText(word);
        },
        [box, member](Preferences& p) { p.*member = box->currentText().toStdString(); });
}

void PreferencesPage::addWidget(QWidget* widget, const QString& words)
{
    fields_.push_back({words, widget, [](const Preferences&) {}, [](Preferences&) {}});
    form_->addRow(widget);
}

void PreferencesPage::load(const Preferences& preferences)
{
    for (const Field& field : fields_)
        field.load(preferences);
}

void PreferencesPage::store(Preferences& preferences) const
{
    for (const Field& field : fields_)
        field.store(preferences);
}

int PreferencesPage::search(const QString& words)
{
    int found = 0;
    const bool isTitle = title_.contains(words, Qt::CaseInsensitive);
    for (const Field& field : fields_) {
        const bool fits = isTitle || field.label.contains(words, Qt::CaseInsensitive);
        if (QWidget* label = form_->labelForField(field.widget))
            label->setVisible(fits);
        field.widget->setVisible(fits);
        found += fits ? 1 : 0;
    }
    return found;
}

}  // namespace planewright
