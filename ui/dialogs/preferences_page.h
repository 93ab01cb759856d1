// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <functional>
#include <vector>

#include <QString>
#include <QStringList>
#include <QWidget>

#include "ui/common/preferences.h"

class QFormLayout;
class QLabel;

namespace planewright {

/// A page of preferences: labelled fields, each of which knows its member of the value.
class PreferencesPage : public QWidget {
    Q_OBJECT

public:
    explicit PreferencesPage(QString title, QWidget* parent = nullptr);

    const QString& title() const { return title_; }

    /// A box of words for a member that is an enumeration, in the order of its values.
    template <class Enum>
    void addChoice(const QString& label, const QString& name, const QStringList& words, Enum Preferences::*member)
    {
        addIndex(
            label, name, words, [member](const Preferences& p) { return static_cast<int>(p.*member); },
            [member](Preferences& p, int index) { p.*member = static_cast<Enum>(index); });
    }
    void addIndex(const QString& label, const QString& name, const QStringList& words,
                  std::function<int(const Preferences&)> get, std::function<void(Preferences&, int)> set);
    void addToggle(const QString& label, const QString& name, bool Preferences::*member);
    /// A number with its unit between limits.
    void addNumber(const QString& label, const QString& name, const QString& unit, double lowest, double highest,
                   int decimals, double Preferences::*member);
    void addFolder(const QString& label, const QString& name, const QString& placeholder,
                   std::string Preferences::*member);
    /// One of some words, which is the value.
    void addWord(const QString& label, const QString& name, const QStringList& words, std::string Preferences::*member);
    /// A widget for things to do, in a line of its own.
    void addWidget(QWidget* widget, const QString& words);

    void load(const Preferences& preferences);
    void store(Preferences& preferences) const;

    /// Shows only the fields with these words in their labels; gives how many there are.
    int search(const QString& words);

private:
    struct Field {
        QString label;
        QWidget* widget = nullptr;
        std::function<void(const Preferences&)> load;
        std::function<void(Preferences&)> store;
    };
    void add(const QString& label, const QString& name, QWidget* widget, std::function<void(const Preferences&)> load,
             std::function<void(Preferences&)> store);

    QString title_;
    QFormLayout* form_;
    std::vector<Field> fields_;
};

}  // namespace planewright
