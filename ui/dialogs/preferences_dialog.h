// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include <QDialog>
#include <QList>
#include <QSet>
#include <QStringList>

#include "ui/common/preferences.h"

class QAction;
class QLabel;
class QListWidget;
class QStackedWidget;

namespace planewright {

class PreferencesPage;
class ShortcutsPage;

/// What the preferences are about besides themselves.
struct PreferencesContext {
    QStringList presets;              ///< that a scan may begin with
    QList<QAction*> actions;          ///< whose keys may be others
    QSet<QString> keptShortcuts;      ///< object names of actions that keep their own keys
    QList<QAction*> advancedActions;  ///< shown as buttons: reset layout, open folders
};

/// Preferences on pages, with a line to search in. Nothing is in force before OK or Apply.
class PreferencesDialog : public QDialog {
    Q_OBJECT

public:
    PreferencesDialog(Preferences preferences, const PreferencesContext& context, QWidget* parent = nullptr);

    /// As the fields are now.
    Preferences preferences() const;

signals:
    void applied(const planewright::Preferences& preferences);

private:
    void addPage(PreferencesPage* page);
    void addShortcuts(const PreferencesContext& context);
    void addTab(QWidget* page, const QString& title);
    void search(const QString& words);
    void restoreDefaults();

    Preferences loaded_;
    std::vector<PreferencesPage*> pages_;
    ShortcutsPage* shortcuts_ = nullptr;
    QListWidget* list_;
    QStackedWidget* stack_;
    QLabel* nothing_;
};

}  // namespace planewright
