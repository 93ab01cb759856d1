// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <QWidget>

#include "ui/common/device_setup.h"

class QDoubleSpinBox;
class QFormLayout;
class QLineEdit;
class QToolButton;

namespace planewright {

/// What is set once for a rig: its limits and lever arm, how it moves, and where its dialogues are kept. Folded away
/// until somebody asks for it.
class DeviceDetails : public QWidget {
    Q_OBJECT

public:
    explicit DeviceDetails(QWidget* parent = nullptr);

    /// Sets what is shown here, and leaves the rest of a setup as it is.
    void writeTo(DeviceSetup& setup) const;
    void setSetup(const DeviceSetup& setup);
    void setOpen(bool open);

    /// What is wrong in these fields; empty where nothing is.
    QString problem() const;

signals:
    void changed();

private:
    QDoubleSpinBox* addNumber(QFormLayout* form, const QString& label, const QString& name, const QString& unit,
                              double lowest, double highest, const QString& tip);
    void addFolder(QFormLayout* form);

    QToolButton* header_;
    QWidget* body_;
    QDoubleSpinBox* cluster_;
    QDoubleSpinBox* lowest_;
    QDoubleSpinBox* highest_;
    QDoubleSpinBox* fastest_;
    QDoubleSpinBox* travelSpeed_;
    QDoubleSpinBox* settle_;
    QDoubleSpinBox* axisOffset_;
    QLineEdit* dialogues_;
};

}  // namespace planewright
