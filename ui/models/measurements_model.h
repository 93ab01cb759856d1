// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>
#include <QAbstractTableModel>

#include "ui/common/length_style.h"
#include "ui/common/shown_map.h"

namespace planewright {

/// A distance or an angle that someone took: as the map was at that moment.
struct Measurement {
    QString what;                           ///< "P03 – P07", "Point – P03"
    std::optional<double> distance;         ///< [m]
    std::optional<double> angle;            ///< [rad]
    std::optional<Eigen::Vector3d> offset;  ///< from the first to the second [m]
    int step = -1;                          ///< the map's
    Eigen::Vector3d from = Eigen::Vector3d::Zero();
    Eigen::Vector3d to = Eigen::Vector3d::Zero();  ///< where the line of the distance may be drawn [m]
};

enum class MeasurementColumn { What, Distance, Angle, Right, Forward, Up, Step };
inline constexpr int kMeasurementColumns = 7;

/// The measurements taken, in the order in which they were taken.
class MeasurementsModel : public QAbstractTableModel {
    Q_OBJECT

public:
    explicit MeasurementsModel(QObject* parent = nullptr);

    /// Measurements to come are of this map.
    void setMap(std::shared_ptr<const ShownMap> map) { map_ = std::move(map); }
    void setLengthStyle(const LengthStyle& style);

    /// From point to point [m]; its angle is the line's slope against level.
    void addPoints(const Eigen::Vector3d& from, const Eigen::Vector3d& to);
    /// From a point [m] to its foot on a plane. False where the map has no such plane.
    bool addPointAndPlane(const Eigen::Vector3d& point, PlaneId plane);
    /// The angle between two planes, and their distance where they are parallel within 5°. False as above.
    bool addPlanes(PlaneId first, PlaneId second);
    /// The angle at a point between two others; none where two of them are one. False then.
    bool addAngle(const Eigen::Vector3d& corner, const Eigen::Vector3d& first, const Eigen::Vector3d& second);

    void remove(int row);
    void clear();
    const Measurement& at(int row) const { return measurements_[static_cast<std::size_t>(row)]; }

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    void append(Measurement measurement);
    const ShownPlane* planeOf(PlaneId id) const;
    Eigen::Vector3d middleOf(const ShownPlane& plane) const;

    std::shared_ptr<const ShownMap> map_;
    std::vector<Measurement> measurements_;
    LengthStyle style_;
};

}  // namespace planewright
