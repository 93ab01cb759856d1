// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>
#include <optional>
#include <vector>

#include <QObject>

#include "app/session/scan_history.h"
#include "app/session/session_run.h"

namespace planewright {

/// The slices of a scan extracted beside it with other parameters, on a thread of its own.
///
/// Lives in the GUI's thread, where its signals come. It keeps the slices that it was given: the scan may go on, be
/// extracted anew or be closed.
class ScanBranch : public QObject {
    Q_OBJECT

public:
    /// Slices as they were measured, with what is said once about them; `plannedSteps` as of the scan.
    ScanBranch(ScanDescription measured, std::vector<SharedSlice> slices, const Parameters& parameters,
               int plannedSteps, QObject* parent = nullptr);

    const Parameters& parameters() const { return parameters_; }
    /// All of its steps so far.
    ScanHistory& history() { return history_; }
    const ScanHistory& history() const { return history_; }
    /// Every slice was worked in, and the forced last pass has been made.
    bool isFinished() const { return isFinished_; }
    /// What ended it early.
    const std::optional<Error>& problem() const { return problem_; }

signals:
    /// history() has grown.
    void grown(int steps);
    /// It is finished, or a problem() has ended it.
    void ended();

private:
    void take();

    Parameters parameters_;
    std::optional<Error> problem_;
    bool isFinished_ = false;
    std::unique_ptr<SessionRun> run_;
    ScanHistory history_;
};

}  // namespace planewright
