// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include <QDialog>

class QListWidget;
class QPushButton;

namespace planewright {

/// All that was done to a scan, in its order, with what of it is undone; and the way back and forth in it.
class HistoryDialog : public QDialog {
    Q_OBJECT

public:
    explicit HistoryDialog(QWidget* parent = nullptr);

    struct Line {
        QString text;
        bool isUndone = false;
    };
    void setLines(const std::vector<Line>& lines, bool canUndo, bool canRedo);

signals:
    void undoRequested();
    void redoRequested();

private:
    QListWidget* lines_;
    QPushButton* undo_;
    QPushButton* redo_;
};

}  // namespace planewright
