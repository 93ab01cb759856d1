// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <QStringList>
#include <QWidget>

#include "ui/common/simulation_setup.h"

class QComboBox;
class QLabel;
class QPushButton;
class QStackedWidget;

namespace planewright {

class ProblemLabel;
class RecordingForm;
class SimulatorForm;

/// Where the slices come from: a simulated room or a recording, with what there is to set of each.
class SourcePanel : public QWidget {
    Q_OBJECT

public:
    explicit SourcePanel(QWidget* parent = nullptr);

    /// Shows what is opened by other ways.
    void showSimulation(const SimulationSetup& setup);
    void showRecording(const QString& file);
    SimulationSetup simulation() const;

    /// Recordings opened lately, newest first.
    void setRecentFiles(const QStringList& files);

signals:
    /// A room is to be scanned; `addressOf(setup)` names it.
    void simulationRequested(const planewright::SimulationSetup& setup);
    /// A recording is to be opened: its file, or `replay:FILE?speed=X`.
    void openRequested(const QString& address);

private:
    void check();
    void open();

    QComboBox* type_;
    QStackedWidget* forms_;
    SimulatorForm* simulator_;
    RecordingForm* recording_;
    QLabel* size_;
    ProblemLabel* problem_;
    QPushButton* open_;
};

}  // namespace planewright
