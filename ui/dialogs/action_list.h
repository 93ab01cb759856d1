// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include <QList>
#include <QString>

class QAction;

namespace planewright {

/// An action as lists show it.
struct ListedAction {
    QAction* action = nullptr;
    QString group;  ///< the menu it is in; empty for none
    QString text;   ///< without the mark of its mnemonic
    QString keys;   ///< its shortcuts, as they are written on this system
};

/// The actions that have a name and a text, each once, in the order given.
std::vector<ListedAction> listedActions(const QList<QAction*>& actions);

/// How well a query fits a text: its letters in their order, better at the beginnings of words and side by side; below
/// 0 where it does not fit. Blanks and capitals do not matter.
int fuzzyFit(const QString& query, const QString& text);

}  // namespace planewright
