// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/window/clip_control.h"

namespace planewright {

namespace {

constexpr double kAir = 0.1;           // [m]
constexpr double kShownAtFirst = 0.6;  // of the height

}  // namespace

ClipControl::ClipControl(WindowParts& parts) : QObject(&parts), parts_(parts)
{
    connect(parts_.window->actions()[QStringLiteral("actClipBox")], &QAction::toggled, this, &ClipControl::use);
    ClipBoxPanel* panel = parts_.clipBoxPanel;
    connect(panel, &ClipBoxPanel::useRequested, parts_.window->actions()[QStringLiteral("actClipBox")],
            &QAction::setChecked);
    connect(panel, &ClipBoxPanel::boxChanged, this, &ClipControl::show);
    connect(panel, &ClipBoxPanel::fitRequested, this, [this, panel] {
        panel->setBox(around(1.0));
        show(panel->box());
    });
    connect(&parts_.session, &ScanSession::projectChanged, this, [this] {
        isSet_ = false;
        parts_.window->actions()[QStringLiteral("actClipBox")]->setChecked(false);
    });
}

Eigen::AlignedBox3d ClipControl::around(double shareOfHeight) const
{
    Eigen::AlignedBox3d box = parts_.window->view().scene().bounds();
    if (box.isEmpty())
        return box;
    box.max().z() = box.min().z() + shareOfHeight * box.sizes().z();
    return {box.min() - Eigen::Vector3d::Constant(kAir),
            box.max() + Eigen::Vector3d{kAir, kAir, shareOfHeight < 1.0 ? 0.0 : kAir}};
}

void ClipControl::use(bool on)
{
    ClipBoxPanel& panel = *parts_.clipBoxPanel;
    panel.setInUse(on);
    if (!on) {
        parts_.window->view().setClipBox(std::nullopt);
        return;
    }
    if (const Eigen::AlignedBox3d box = around(kShownAtFirst); !isSet_ && !box.isEmpty()) {
        panel.setBox(box);
        isSet_ = true;
    }
    show(panel.box());
    parts_.showClipBox();
}

void ClipControl::show(const Eigen::AlignedBox3d& box)
{
    if (!parts_.window->actions()[QStringLiteral("actClipBox")]->isChecked())
        return;
    if (box.isEmpty() || (box.sizes().array() <= 0.0).any()) {
        parts_.say(tr("The clip box is empty: let each end lie beyond its beginning."));
        return;
    }
    parts_.window->view().setClipBox(box);
}

}  // namespace planewright
