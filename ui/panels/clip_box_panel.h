// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>

#include <Eigen/Geometry>
#include <QWidget>

class QCheckBox;
class QDoubleSpinBox;
class QPushButton;

namespace planewright {

/// The box outside of which the 3D view shows nothing: whether it is in use, and from where to where it goes [m].
class ClipBoxPanel : public QWidget {
    Q_OBJECT

public:
    explicit ClipBoxPanel(QWidget* parent = nullptr);

    /// Tells nobody.
    void setInUse(bool inUse);
    void setBox(const Eigen::AlignedBox3d& box);
    /// What is typed; empty where an end lies before its beginning.
    Eigen::AlignedBox3d box() const;

signals:
    void useRequested(bool inUse);
    void boxChanged(const Eigen::AlignedBox3d& box);
    /// The box is to go round all of the scan.
    void fitRequested();

private:
    void refresh();

    QCheckBox* inUse_;
    std::array<QDoubleSpinBox*, 3> from_;
    std::array<QDoubleSpinBox*, 3> to_;
    QPushButton* fit_;
};

}  // namespace planewright
