// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <QAction>
#include <QHash>
#include <QList>
#include <QMenu>
#include <QMenuBar>
#include <QObject>
#include <QWidget>

namespace planewright {

/// All actions of the window, made from one table: text, menu, shortcut and what they do to the eye.
///
/// Menus, tool bar, the list of shortcuts and the command palette are all made from these. Shortcuts of a single letter
/// work only while the 3D view or the timeline has the focus, so that they do not take letters from text fields.
class WindowActions : public QObject {
    Q_OBJECT

public:
    /// `view` is the widget of single-letter shortcuts.
    WindowActions(QWidget* window, QWidget* view);

    /// The action of an objectName, which must exist.
    QAction* operator[](const QString& name) const;
    /// In the order of the menus.
    const QList<QAction*>& all() const { return all_; }

    /// Fills a menu bar; `submenus` are placed where the table names them.
    void fillMenuBar(QMenuBar& bar);

    /// Lets shortcuts of single letters work while this widget has the focus, as well as in the view.
    void letKeysWorkIn(QWidget& widget);

    /// A menu that is filled by others: "recent", "colourBy", "theme", "class".
    QMenu* submenu(const QString& name) const { return submenus_[name]; }

    /// Whether an action's shortcut may be changed: stop motion keeps its own.
    static bool isFixed(const QAction& action);

private:
    QWidget* window_;
    QList<QAction*> all_;
    QHash<QString, QAction*> byName_;
    QHash<QString, QMenu*> submenus_;
};

}  // namespace planewright
