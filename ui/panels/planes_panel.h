// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <QList>
#include <QWidget>

#include "core/params/parameters.h"
#include "ui/models/map_selection.h"
#include "ui/models/planes_model.h"

class QAction;

namespace planewright {

class FilteredTable;

/// The table of planes: filter, columns, totals; what is chosen in it is what is chosen everywhere.
class PlanesPanel : public QWidget {
    Q_OBJECT

public:
    /// Model and selection must live as long as this.
    PlanesPanel(PlanesModel& model, MapSelection& selection, QWidget* parent = nullptr);

    /// What the context menu offers above "Copy rows"; null is a separator.
    void setContextActions(const QList<QAction*>& actions) { contextActions_ = actions; }
    /// What the text in an empty table is about.
    void setParameters(const Parameters& parameters);

    FilteredTable* table() const { return table_; }

public slots:
    /// Lets the user type a name for the current plane, in the table.
    void beginRename();
    void focusFilter();

signals:
    void showUnfittedRequested();
    /// The parameter that no plane fulfilled is to be seen: its key.
    void parameterRequested(const QString& key);
    /// The pointer or the keyboard is on a plane to be looked at: a double click, or Enter.
    void zoomRequested(planewright::PlaneId plane);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void takeSelection();
    void giveSelection();
    void sayWhyEmpty();
    void sumUp();
    void showMenu(const QPoint& place);

    PlanesModel& model_;
    MapSelection& selection_;
    FilteredTable* table_;
    QList<QAction*> contextActions_;
    Parameters parameters_;
    bool taking_ = false;  // a selection from elsewhere is on its way into the table
};

}  // namespace planewright
