// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <functional>
#include <optional>
#include <utility>

#include <QDialog>

#include "core/geometry/pose.h"

class QCheckBox;
class QDoubleSpinBox;
class QFormLayout;

namespace planewright {

/// Asks where a stop is: place and heading, or that nobody says so.
class PlaceDialog : public QDialog {
    Q_OBJECT

public:
    struct Words {
        QString name;  ///< of the dialog and, with what they are, of its fields: "odometry" gives "odometryX"
        QString title;
        QString known;  ///< that somebody says where it is
    };
    /// Begins with what is known so far, or with `start` where nothing is. A stop that is tilted keeps that.
    PlaceDialog(const Words& words, const std::optional<Pose>& known, const Pose& start, QWidget* parent = nullptr);

    /// Offers to move a place to where it fits better; a place and what is to be said of it come back.
    void offerToFit(const QString& text, std::function<std::pair<Pose, QString>(const Pose&)> fit);

    /// Says how else it may be placed.
    void explain(const QString& text);

    std::optional<Pose> place() const;
    /// What the numbers say, whether it counts or not.
    Pose pose() const;
    /// Places it there.
    void setPlace(const Pose& pose);

signals:
    /// By whatever means, also when it counts no more.
    void placeChanged();

private:
    void fill(const Pose& pose);

    QString name_;
    Pose before_;
    double headingBefore_ = 0.0;  ///< [rad]
    QFormLayout* form_;
    QCheckBox* isKnown_;
    QDoubleSpinBox* place_[3];
    QDoubleSpinBox* heading_;
};

}  // namespace planewright
