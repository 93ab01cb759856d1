// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>
#include <vector>

#include <QObject>

#include "app/session/scan_branch.h"
#include "app/window/map_worker.h"
#include "app/window/scan_control.h"
#include "app/window/window_parts.h"
#include "ui/models/compare_model.h"
#include "ui/panels/compare_panel.h"
#include "ui/theme/theme_follower.h"

namespace planewright {

/// Extracts the scan once more with other parameters, and shows both on one timeline: two views with one camera, and a
/// table of what differs.
class CompareControl : public QObject {
    Q_OBJECT

public:
    CompareControl(WindowParts& parts, ScanControl& scan, ThemeFollower& follower);

    /// Null without one.
    const ScanBranch* branch() const { return branch_.get(); }
    /// True while both maps are worked out or about to be shown.
    bool isBusy() const { return worker_.isBusy() || (branch_ && !branch_->isFinished() && !branch_->problem()); }

private:
    /// Parameters that a scan may be compared with.
    struct Choice {
        QString name;
        QString meaning;
        Parameters parameters;
    };

    /// With what `present` knows of the scanner; that itself comes last.
    static std::vector<Choice> choices(const Parameters& present);
    QString nameOfScan() const;
    void refreshChoices();
    void chooseAnother();
    void connectActions();
    void connectView();
    void follow(const View3d& from, View3d& to);
    void run(int choice);
    void close();
    void takeGrown();
    void takeEnded();
    void showStep();
    /// What B is beside the phase that is looked at; the fact tells which it is, empty for the whole step.
    std::shared_ptr<const Snapshot> phaseOfBranch(QString& fact);
    void choosePlanes(PlaneId a, PlaneId b);
    void takeSelection();
    void showExample();

    WindowParts& parts_;
    ScanControl& scan_;
    ThemeFollower& follower_;
    CompareModel model_;
    ComparePanel* panel_;
    std::vector<Choice> choices_;
    std::unique_ptr<ScanBranch> branch_;
    QString branchName_;
    std::unique_ptr<QObject> example_;  ///< waits for the scan of the example
    MapWorker worker_;
    bool isLinked_ = false;     ///< the second view has been made and follows the first
    bool isFollowing_ = false;  ///< one camera is being set from the other
};

}  // namespace planewright
