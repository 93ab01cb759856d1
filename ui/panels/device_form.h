// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include <QWidget>

#include "ui/common/device_setup.h"

class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;
class QPushButton;
class QVBoxLayout;

namespace planewright {

class DeviceDetails;
class ProblemLabel;

/// A laser and a tilt unit: which ones, how they scan, whether they work, and how they are.
class DeviceForm : public QWidget {
    Q_OBJECT

public:
    explicit DeviceForm(QWidget* parent = nullptr);

    DeviceSetup setup() const;
    void setSetup(const DeviceSetup& setup);

    /// What is connected now; what was typed or chosen stays.
    void setChoices(const std::vector<DeviceChoice>& choices);
    /// The checks of the last test, in order; empty: none was made.
    void setChecks(const std::vector<DeviceCheck>& checks);
    /// What the devices say of themselves; empty where none are connected.
    void setFacts(const std::vector<DeviceFact>& facts);
    /// Nothing can be tested or moved while they scan, or while something else is done with them.
    void setTestable(bool testable);
    /// Devices that are connected are brought to level where they are.
    void setConnectedHead(bool isThere);
    /// The tilt unit has turned itself off, or was stopped in an emergency: a person sees to it and releases it.
    void setRecoverable(bool recoverable);
    /// What keeps all of a kind from being found; empty: nothing.
    void setSearchProblem(const QString& problem);

    /// Whether there is a head that can be brought to level now: one that is connected, or one with limits that make
    /// sense.
    bool canGoHome() const;
    /// Whether devices can be looked for and tested now.
    bool isTestable() const { return isTestable_; }
    /// Whether there is a unit that waits to be released.
    bool canRecover() const;

    /// Find, Test and Move to level, for a place where they stay in sight. Below the fields until somebody takes them.
    QWidget* buttons() const { return buttons_; }
    const DeviceDetails& details() const { return *details_; }

    /// What is missing or wrong in what was chosen; empty where nothing is.
    QString problem() const;

signals:
    void changed();
    /// What is connected is to be looked for, and asked who it is.
    void searchRequested();
    void testRequested();
    /// The head is to go to level.
    void homeRequested();
    /// The cause is seen to: the tilt unit is to be released.
    void recoverRequested();

private:
    void addButtons(QVBoxLayout* layout);
    void addRecovery(QVBoxLayout* layout);
    void check();

    QComboBox* addAddress(QFormLayout* form, const QString& label, const QString& name, const QString& hint);
    QDoubleSpinBox* addAngle(QFormLayout* form, const QString& label, const QString& name, double lowest,
                             double highest);
    const DeviceChoice* troubled(const QComboBox* box) const;
    QString limitProblem() const;

    std::vector<DeviceChoice> choices_;
    QComboBox* laser_;
    QComboBox* unit_;
    ProblemLabel* trouble_;
    QPushButton* copyCure_;
    QString searchProblem_;
    QComboBox* mode_;
    QDoubleSpinBox* firstTilt_;
    QDoubleSpinBox* lastTilt_;
    QDoubleSpinBox* tiltStep_;
    QDoubleSpinBox* firstBearing_;
    QDoubleSpinBox* lastBearing_;
    QWidget* buttons_;
    QPushButton* search_;
    QPushButton* test_;
    QPushButton* home_;
    QWidget* recovery_;
    QPushButton* recover_;
    DeviceDetails* details_;
    bool isTestable_ = true;
    bool hasConnectedHead_ = false;
    bool isRecoverable_ = false;
    QLabel* checks_;
    QLabel* facts_;
};

}  // namespace planewright
