// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/window/source_control.h"

namespace planewright {

SourceControl::SourceControl(WindowParts& parts, const ScanControl& scan, const DeviceControl& devices)
    : QObject(&parts), parts_(parts), scan_(scan), devices_(devices)
{
    connect(&parts_.session, &ScanSession::projectChanged, this, &SourceControl::show);
}

void SourceControl::show()
{
    SourcePanel& panel = *parts_.sourcePanel;
    const std::string& text = parts_.session.address();
    if (text == shown_)
        return;
    shown_ = text;
    const auto address = parseSourceAddress(text);
    if (text.empty() || !address) {
        panel.setOpened({});
        return;
    }
    switch (address->kind) {
        case SourceAddress::Kind::Simulation: {
            SimulationSetup setup = scan_.simulated().value_or(SimulationSetup{});
            setup.scene = address->name;
            setup.seed = address->seed;
            setup.speed = address->speed;
            panel.showSimulation(setup);
            break;
        }
        case SourceAddress::Kind::Laser:
            panel.showDevices(devices_.connected());
            break;
        case SourceAddress::Kind::Replay:
            panel.showRecording(QString::fromStdString(address->name), address->speed);
            break;
        case SourceAddress::Kind::File:
            panel.showRecording(QString::fromStdString(address->name));
            break;
    }
    panel.setOpened(QString::fromStdString(parts_.session.status().source));
}

}  // namespace planewright
