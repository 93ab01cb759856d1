// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <functional>

#include <QWidget>

#include "ui/models/log_model.h"

class QPushButton;

namespace planewright {

class FilteredTable;

/// What the program has said, with a filter; follows the newest line while that is in view.
class LogPanel : public QWidget {
    Q_OBJECT

public:
    /// The model must live as long as this.
    explicit LogPanel(LogModel& model, QWidget* parent = nullptr);

    /// What stands above the last lines in a bug report: versions, renderer, scanner. With it the button is there.
    void setReportHead(std::function<QString()> head);

    /// The bug report: its head and the last 200 lines.
    QString bugReport() const;

    FilteredTable* table() const { return table_; }

private:
    LogModel& model_;
    FilteredTable* table_;
    QPushButton* copy_;
    std::function<QString()> head_;
    bool follows_ = true;  // the newest line is in view
};

}  // namespace planewright
