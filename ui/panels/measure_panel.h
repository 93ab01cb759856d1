// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <QWidget>

#include "ui/models/measurements_model.h"

class QAction;

namespace planewright {

class FilteredTable;

/// The measurements taken: to be read, copied and removed.
class MeasurePanel : public QWidget {
    Q_OBJECT

public:
    /// The model must live as long as this.
    explicit MeasurePanel(MeasurementsModel& model, QWidget* parent = nullptr);

    FilteredTable* table() const { return table_; }
    /// "Remove", `actRemoveMeasurement`, Del while the table has the keyboard.
    QAction* removeAction() const { return remove_; }

private:
    void removeChosen();

    MeasurementsModel& model_;
    FilteredTable* table_;
    QAction* remove_;
};

}  // namespace planewright
