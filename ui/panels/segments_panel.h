// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <QWidget>

#include "ui/models/map_selection.h"
#include "ui/models/segments_model.h"

class QCheckBox;

namespace planewright {

class FilteredTable;

/// The table of line segments, all or those of no plane.
class SegmentsPanel : public QWidget {
    Q_OBJECT

public:
    /// Model and selection must live as long as this.
    SegmentsPanel(SegmentsModel& model, MapSelection& selection, QWidget* parent = nullptr);

    FilteredTable* table() const { return table_; }

public slots:
    void showUnfittedOnly(bool only);

private:
    void takeSelection();
    void giveSelection();
    void sumUp();
    void sayWhyEmpty();

    SegmentsModel& model_;
    MapSelection& selection_;
    FilteredTable* table_;
    QCheckBox* unfittedOnly_;
    bool taking_ = false;  // a selection from elsewhere is on its way into the table
};

}  // namespace planewright
