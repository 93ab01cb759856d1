// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/window/odometry_dialog.h"

#include <cmath>

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QFormLayout>

#include "core/types/angle.h"
#include "ui/panels/plain_fields.h"

namespace planewright {

namespace {

constexpr double kFarthestStop = 1e5;  // [m]

/// How far a pose is turned about the vertical [rad].
double headingOf(const Pose& pose)
{
    const Eigen::Vector3d right = pose.rotation * Eigen::Vector3d::UnitX();
    return std::atan2(right.y(), right.x());
}

}  // namespace

OdometryDialog::OdometryDialog(const QString& stop, const std::optional<Pose>& known, QWidget* parent)
    : QDialog(parent),
      before_(known.value_or(Pose{})),
      headingBefore_(headingOf(before_)),
      isKnown_(new QCheckBox(tr("It is &known where wheels tell it to be"), this)),
      heading_(new PlainSpinBox(this))
{
    setObjectName(QStringLiteral("odometryDialog"));
    setWindowTitle(tr("Odometry of %1").arg(stop));
    auto* form = new QFormLayout(this);
    isKnown_->setObjectName(QStringLiteral("odometryKnown"));
    isKnown_->setChecked(known.has_value());
    form->addRow(isKnown_);
    const char* const names[3] = {"&x, right", "&y, ahead", "&z, up"};
    for (int axis = 0; axis < 3; ++axis) {
        auto* field = new PlainSpinBox(this);
        field->setObjectName(QStringLiteral("odometry%1").arg(QLatin1Char("XYZ"[axis])));
        field->setRange(-kFarthestStop, kFarthestStop);
        field->setDecimals(3);
        field->setSingleStep(0.1);
        field->setSuffix(QStringLiteral(" m"));
        field->setValue(before_.translation[axis]);
        place_[axis] = field;
        form->addRow(tr(names[axis]), field);
    }
    heading_->setObjectName(QStringLiteral("odometryHeading"));
    heading_->setRange(-360.0, 360.0);
    heading_->setDecimals(2);
    heading_->setSuffix(QStringLiteral("°"));
    heading_->setValue(toDegrees(headingBefore_));
    form->addRow(tr("&Turned to the left"), heading_);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    form->addRow(buttons);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    const auto refresh = [this](bool on) {
        for (QDoubleSpinBox* field : place_)
            field->setEnabled(on);
        heading_->setEnabled(on);
    };
    connect(isKnown_, &QCheckBox::toggled, this, refresh);
    refresh(known.has_value());
}

std::optional<Pose> OdometryDialog::odometry() const
{
    if (!isKnown_->isChecked())
        return std::nullopt;
    const Eigen::AngleAxisd turn(degrees(heading_->value()) - headingBefore_, Eigen::Vector3d::UnitZ());
    return Pose{(turn * before_.rotation).normalized(), {place_[0]->value(), place_[1]->value(), place_[2]->value()}};
}

}  // namespace planewright
