// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>
#include <set>

#include <QObject>
#include <QTabWidget>
#include <QTimer>

#include "app/window/window_parts.h"
#include "ui/panels/lineage_panel.h"

namespace planewright {

/// Follows the selected planes through time: at another step what they are there is selected, and their lives are
/// shown as a graph.
class LineageControl : public QObject {
    Q_OBJECT

public:
    /// The graph becomes a tab of these.
    LineageControl(WindowParts& parts, QTabWidget& tabs);

    LineagePanel& panel() { return *panel_; }

private:
    void takeSelection();
    void follow();
    void goTo(PlaneId plane, int step);
    void showChart();
    int shownStep() const;

    WindowParts& parts_;
    LineagePanel* panel_;
    QTimer grow_;
    std::shared_ptr<const ShownMap> seen_;       // the map that the selection is of
    std::shared_ptr<const Snapshot> beginning_;  // of the scan that it is of
    std::set<PlaneId> chosen_;                   // what somebody has chosen,
    int chosenAt_ = 0;                           // and at which step
    bool following_ = false;
};

}  // namespace planewright
