// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <functional>
#include <optional>
#include <string>

#include <QStringList>
#include <QWidget>

#include "core/types/error.h"
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

/// Where the slices come from: a simulated room, a recording or devices, with what there is to set of each. The fields
/// scroll; what is wrong and the buttons stay in sight below them.
class SourcePanel : public QWidget {
    Q_OBJECT

public:
    explicit SourcePanel(QWidget* parent = nullptr);

    /// Shows what is opened by other ways.
    void showSimulation(const SimulationSetup& setup);
    /// Played with a speed, where 1 is real time.
    void showRecording(const QString& file, std::optional<double> speed = {});
    void showDevices(const DeviceSetup& setup);
    /// Shows the form of laser and tilt unit as it is.
    void showDevices();
    SimulationSetup simulation() const;
    /// The form of laser and tilt unit.
    DeviceForm& devices() { return *devices_; }

    /// Tells what a scan with devices takes; an empty text where nobody knows them better than an address does. Errors
    /// are sentences about what to give instead.
    using DeviceEstimate = std::function<Result<std::string>(const DeviceSetup& setup)>;
    void setDeviceEstimate(DeviceEstimate estimate);

    /// What the form in sight says now is what is open, under this name; empty: nothing is. From then on the panel
    /// tells where it says something else.
    void setOpened(const QString& name);

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
    /// What a form says.
    struct Said {
        int form = 0;
        SimulationSetup simulation;
        QString recording;
        DeviceSetup devices;

        friend bool operator==(const Said&, const Said&) = default;
    };

    Said said() const;
    void check();
    void open();
    QWidget* makeFoot();
    Result<std::string> sizeOf(const DeviceSetup& setup) const;

    QComboBox* type_;
    QStackedWidget* forms_;
    SimulatorForm* simulator_;
    RecordingForm* recording_;
    DeviceForm* devices_;
    QLabel* size_;
    ProblemLabel* problem_;
    QPushButton* open_;
    QLabel* unused_;
    QString openedName_;
    Said opened_;
    DeviceEstimate deviceEstimate_;
};

}  // namespace planewright
