// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <QWidget>

#include "ui/common/simulation_setup.h"

class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QLineEdit;

namespace planewright {

/// What there is to set of a simulated scan.
class SimulatorForm : public QWidget {
    Q_OBJECT

public:
    explicit SimulatorForm(QWidget* parent = nullptr);

    SimulationSetup setup() const;
    void setSetup(const SimulationSetup& setup);

signals:
    void changed();

private:
    QDoubleSpinBox* addAngle(QFormLayout* form, const QString& label, const QString& name, double lowest,
                             double highest);

    QComboBox* scene_;
    QLineEdit* seed_;
    QComboBox* noise_;
    QDoubleSpinBox* firstTilt_;
    QDoubleSpinBox* lastTilt_;
    QDoubleSpinBox* tiltStep_;
    QDoubleSpinBox* firstBearing_;
    QDoubleSpinBox* lastBearing_;
    QDoubleSpinBox* bearingStep_;
    QComboBox* speed_;
};

/// Speeds that a scan may be played at: their words and the numbers in data.
void addSpeeds(QComboBox* box);
/// Chooses a speed; one that is not there is added.
void chooseSpeed(QComboBox* box, double speed);

}  // namespace planewright
