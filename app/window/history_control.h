// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>

#include <QObject>
#include <QString>
#include <QTimer>

#include "app/window/window_parts.h"

namespace planewright {

/// Looks at the scan as it was after a step, or the last one before it, and at all of it from its last step on. Usage
/// error where there is none.
Result<void> lookAtStep(WindowParts& parts, int step);

/// A phase, or a pass of the last one, as a state chip names it: "fitting planes".
QString phaseChipWords(const PhaseState& state);

/// Shows in every view the moment of the scan that the playhead is at, and tells how its step went.
class HistoryControl : public QObject {
    Q_OBJECT

public:
    explicit HistoryControl(WindowParts& parts);

    /// How the step at the playhead went; null without one. Works it out where that was not done yet: some
    /// milliseconds, tens of them in scans of a thousand steps.
    std::shared_ptr<const PhasedStep> explained();

    /// One phase further or back: from the last phase of a step to the first of the next, and the other way round.
    void goByPhase(int by);

signals:
    /// The phase that is looked at, in words; empty for the whole step.
    void phaseShown(const QString& phase);
    /// The playhead has come to rest at a step that explained() tells of, or at none.
    void rested();

private:
    void takeHistory();
    void takePlace();
    void takePhase();

    WindowParts& parts_;
    QTimer rest_;
    int explainedPlace_ = -1;
    std::shared_ptr<const PhasedStep> explained_;
};

}  // namespace planewright
