// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <map>
#include <string>
#include <vector>

#include <QSet>
#include <QWidget>

#include "ui/dialogs/action_list.h"

class QKeySequenceEdit;
class QTableWidget;

namespace planewright {

class ProblemLabel;

/// The keys of each action, by object name, as far as they are not the program's own.
using ShortcutMap = std::map<std::string, std::vector<std::string>>;

/// Gives actions other keys: one of their own beside or instead of the program's. What is kept can gain keys and never
/// lose its own.
class ShortcutsPage : public QWidget {
    Q_OBJECT

public:
    /// `kept` are object names of actions that keep their own keys: what stops motion.
    ShortcutsPage(const QList<QAction*>& actions, ShortcutMap changed, QSet<QString> kept, QWidget* parent = nullptr);

    const ShortcutMap& changed() const { return changed_; }
    void restoreDefaults();
    /// Hides what does not have these words; gives how many are left.
    int search(const QString& words);

private:
    void fill();
    void showCurrent();
    void take();
    QString userOf(const QKeySequence& keys, const QString& except) const;

    std::vector<ListedAction> actions_;
    ShortcutMap changed_;
    QSet<QString> kept_;
    QTableWidget* table_;
    QKeySequenceEdit* edit_;
    ProblemLabel* problem_;
};

/// Keeps the keys that actions come with, for the page to go back to; called before preferences change any.
void rememberOwnKeys(const QList<QAction*>& actions);

/// Gives actions the keys of the preferences.
void applyShortcuts(const QList<QAction*>& actions, const ShortcutMap& changed, const QSet<QString>& kept);

}  // namespace planewright
