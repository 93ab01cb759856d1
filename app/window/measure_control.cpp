// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/window/measure_control.h"

#include <array>

namespace planewright {

namespace {

constexpr std::array<const char*, 3> kActions{"actMeasureDistance", "actMeasurePointPlane", "actMeasureAngle"};

}  // namespace

MeasureControl::MeasureControl(WindowParts& parts) : QObject(&parts), parts_(parts)
{
    for (std::size_t i = 0; i < kActions.size(); ++i) {
        connect(parts_.window->actions()[QLatin1String(kActions[i])], &QAction::toggled, this,
                [this, i](bool on) { begin(static_cast<Kind>(i + 1), on); });
    }
    connect(&parts_.window->view(), &View3d::pointPicked, this, &MeasureControl::take);
    for (auto signal : {&QAbstractItemModel::rowsInserted, &QAbstractItemModel::rowsRemoved})
        connect(&parts_.measurements, signal, this, &MeasureControl::drawAll);
    connect(&parts_.measurements, &QAbstractItemModel::modelReset, this, &MeasureControl::drawAll);
}

void MeasureControl::begin(Kind kind, bool on)
{
    if (!on) {
        if (kind_ == kind) {
            kind_ = Kind::None;
            parts_.window->view().setMeasuring(false);
            parts_.say({});
        }
        return;
    }
    kind_ = kind;
    first_.reset();
    for (std::size_t i = 0; i < kActions.size(); ++i) {
        if (static_cast<Kind>(i + 1) != kind)
            parts_.window->actions()[QLatin1String(kActions[i])]->setChecked(false);
    }
    parts_.window->view().setMeasuring(true);
    parts_.window->showBottomPanel(QStringLiteral("measurePanel"));
    parts_.say(kind == Kind::Planes   ? tr("Click two planes.")
               : kind == Kind::Points ? tr("Click two points.")
                                      : tr("Click a point, then a plane."));
}

void MeasureControl::take(const Picked& picked)
{
    const bool needsPlane = kind_ == Kind::Planes || (kind_ == Kind::PointAndPlane && first_);
    if (needsPlane && picked.plane == kNoPlane) {
        parts_.say(tr("There is no plane; click where one is."));
        return;
    }
    if (!first_) {
        first_ = picked;
        parts_.say(kind_ == Kind::Points ? tr("Click the second point.") : tr("Click the plane."));
        return;
    }
    const Picked first = *first_;
    first_.reset();
    bool taken = true;
    if (kind_ == Kind::Points)
        parts_.measurements.addPoints(first.place, picked.place);
    else if (kind_ == Kind::PointAndPlane)
        taken = parts_.measurements.addPointAndPlane(first.place, picked.plane);
    else
        taken = first.plane != picked.plane && parts_.measurements.addPlanes(first.plane, picked.plane);
    parts_.say(taken ? tr("Measured; click on for the next.") : tr("Choose two planes that are there and differ."));
}

void MeasureControl::drawAll()
{
    std::vector<MeasuredLine> lines;
    for (int row = 0; row < parts_.measurements.rowCount(); ++row) {
        const Measurement& measurement = parts_.measurements.at(row);
        lines.push_back({measurement.from, measurement.to});
    }
    parts_.window->view().setMeasurements(lines);
}

}  // namespace planewright
