// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <QStringList>
#include <QWidget>

#include "ui/common/device_setup.h"
#include "ui/common/simulation_setup.h"

class QComboBox;
class QLabel;
class QPushButton;
class QStackedWidget;

namespace planewright {

class DeviceForm;
class ProblemLabel;
class RecordingForm;
class SimulatorForm;

/// Where the slices come from: a simulated room, a recording or devices, with what there is to set of each.
class SourcePanel : public QWidget {
    Q_OBJECT

public:
    explicit SourcePanel(QWidget* parent = nullptr);

    /// Shows what is opened by other ways.
    void showSimulation(const SimulationSetup& setup);
    void showRecording(const QString& file);
    void showDevices(const DeviceSetup& setup);
    SimulationSetup simulation() const;
    /// The form of laser and tilt unit.
    DeviceForm& devices() { return *devices_; }

    /// Recordings opened lately, newest first.
    void setRecentFiles(const QStringList& files);

signals:
    /// A room is to be scanned; `addressOf(setup)` names it.
    void simulationRequested(const planewright::SimulationSetup& setup);
    /// A recording is to be opened: its file, or `replay:FILE?speed=X`.
    void openRequested(const QString& address);
    /// A laser and a tilt unit are to be connected.
    void devicesRequested(const planewright::DeviceSetup& setup);
    /// The form of the devices has come into sight.
    void devicesShown();

private:
    void check();
    void open();

    QComboBox* type_;
    QStackedWidget* forms_;
    SimulatorForm* simulator_;
    RecordingForm* recording_;
    DeviceForm* devices_;
    QLabel* size_;
    ProblemLabel* problem_;
    QPushButton* open_;
};

}  // namespace planewright
