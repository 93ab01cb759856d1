// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <utility>
#include <vector>

#include <QObject>
#include <QTabWidget>
#include <QTimer>

#include "app/window/history_control.h"
#include "app/window/window_parts.h"
#include "ui/panels/inspector_panel.h"
#include "ui/panels/why_not_panel.h"

namespace planewright {

/// Tells of the step that the playhead is at: its decisions, and why not.
///
/// While steps come faster than the playhead rests, the reports of their snapshots are shown, a few a second; a step at
/// rest is told phase by phase. Nothing is worked out while nobody sees it.
class InspectorControl : public QObject {
    Q_OBJECT

public:
    InspectorControl(WindowParts& parts, HistoryControl& history);

    /// The tabs in the dock, for what belongs beside these.
    QTabWidget& tabs() { return *tabs_; }
    InspectorPanel& inspector() { return *inspector_; }
    WhyNotPanel& whyNotPanel() { return *whyNot_; }

private:
    void connectInspector();
    void connectWhyNot();
    /// Shows the step at the playhead, told phase by phase or by its report alone.
    void showStep(bool byPhases);
    void select(const std::vector<Operand>& operands);
    void beginWhyNot();
    void askWhyNot();
    QString missing(const Operand& operand) const;

    WindowParts& parts_;
    HistoryControl& history_;
    QTabWidget* tabs_;
    InspectorPanel* inspector_;
    WhyNotPanel* whyNot_;
    QTimer live_;
    std::pair<const Snapshot*, const PhasedStep*> told_;  // what the inspector shows
};

}  // namespace planewright
