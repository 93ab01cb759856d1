// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include <QDialog>

#include "ui/dialogs/action_list.h"

class QLabel;
class QLineEdit;
class QListWidget;

namespace planewright {

/// Finds an action by some letters of its name and does it: arrows choose, Enter does, Esc leaves.
class CommandPalette : public QDialog {
    Q_OBJECT

public:
    explicit CommandPalette(const QList<QAction*>& actions, QWidget* parent = nullptr);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void fill();
    void run();

    std::vector<ListedAction> actions_;
    QLineEdit* query_;
    QListWidget* list_;
    QLabel* nothing_;
};

}  // namespace planewright
