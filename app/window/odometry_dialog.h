// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>

#include <QDialog>

#include "core/geometry/pose.h"

class QCheckBox;
class QDoubleSpinBox;

namespace planewright {

/// Asks where wheels tell a stop to be: place and heading in odometry's own frame, or that nobody knows.
class OdometryDialog : public QDialog {
    Q_OBJECT

public:
    /// Begins with what is known so far. A stop that is tilted keeps that.
    OdometryDialog(const QString& stop, const std::optional<Pose>& known, QWidget* parent = nullptr);

    std::optional<Pose> odometry() const;

private:
    Pose before_;
    double headingBefore_ = 0.0;  ///< [rad]
    QCheckBox* isKnown_;
    QDoubleSpinBox* place_[3];
    QDoubleSpinBox* heading_;
};

}  // namespace planewright
