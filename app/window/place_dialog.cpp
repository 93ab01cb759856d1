// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/window/place_dialog.h"

#include <cmath>

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>

#include "core/types/angle.h"
#include "ui/panels/plain_fields.h"

namespace planewright {

namespace {

constexpr double kFarthestStop = 1e5;  // [m]
constexpr int kSaidWidth = 300;        // [px]

/// How far a pose is turned about the vertical [rad].
double headingOf(const Pose& pose)
{
    const Eigen::Vector3d right = pose.rotation * Eigen::Vector3d::UnitX();
    return std::atan2(right.y(), right.x());
}

}  // namespace

PlaceDialog::PlaceDialog(const Words& words, const std::optional<Pose>& known, const Pose& start, QWidget* parent)
    : QDialog(parent),
      name_(words.name),
      before_(known.value_or(start)),
      headingBefore_(headingOf(before_)),
      form_(new QFormLayout(this)),
      isKnown_(new QCheckBox(words.known, this)),
      heading_(new PlainSpinBox(this))
{
    setObjectName(name_ + QStringLiteral("Dialog"));
    setWindowTitle(words.title);
    form_->setHorizontalSpacing(12);
    isKnown_->setObjectName(name_ + QStringLiteral("Known"));
    isKnown_->setChecked(known.has_value());
    form_->addRow(isKnown_);
    const char* const names[3] = {"&x, right", "&y, ahead", "&z, up"};
    for (int axis = 0; axis < 3; ++axis) {
        auto* field = new PlainSpinBox(this);
        field->setObjectName(name_ + QLatin1Char("XYZ"[axis]));
        field->setRange(-kFarthestStop, kFarthestStop);
        field->setDecimals(3);
        field->setSingleStep(0.1);
        field->setSuffix(QStringLiteral(" m"));
        place_[axis] = field;
        form_->addRow(tr(names[axis]), field);
    }
    heading_->setObjectName(name_ + QStringLiteral("Heading"));
    heading_->setRange(-360.0, 360.0);
    heading_->setDecimals(2);
    heading_->setSuffix(QStringLiteral("°"));
    form_->addRow(tr("&Turned to the left"), heading_);
    fill(before_);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    form_->addRow(buttons);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    const auto refresh = [this](bool on) {
        for (QDoubleSpinBox* field : place_)
            field->setEnabled(on);
        heading_->setEnabled(on);
    };
    connect(isKnown_, &QCheckBox::toggled, this, refresh);
    connect(isKnown_, &QCheckBox::toggled, this, &PlaceDialog::placeChanged);
    for (QDoubleSpinBox* field : {place_[0], place_[1], place_[2], heading_})
        connect(field, &QDoubleSpinBox::valueChanged, this, &PlaceDialog::placeChanged);
    refresh(known.has_value());
}

void PlaceDialog::explain(const QString& text)
{
    auto* said = new QLabel(text, this);
    said->setWordWrap(true);
    said->setMinimumWidth(kSaidWidth);
    form_->insertRow(form_->rowCount() - 1, said);
}

void PlaceDialog::setPlace(const Pose& pose)
{
    {
        const QSignalBlocker quiet(this);
        isKnown_->setChecked(true);
        fill(pose);
    }
    emit placeChanged();
}

void PlaceDialog::offerToFit(const QString& text, std::function<std::pair<Pose, QString>(const Pose&)> fit)
{
    auto* button = new QPushButton(text, this);
    button->setObjectName(name_ + QStringLiteral("Fit"));
    auto* said = new QLabel(this);
    said->setObjectName(name_ + QStringLiteral("Fitted"));
    said->setWordWrap(true);
    said->setMinimumWidth(kSaidWidth);
    said->hide();
    form_->insertRow(form_->rowCount() - 1, button);
    form_->insertRow(form_->rowCount() - 1, said);
    connect(button, &QPushButton::clicked, this, [this, said, fit = std::move(fit)] {
        const auto [fitted, words] = fit(pose());
        setPlace(fitted);
        said->setText(words);
        said->show();
        adjustSize();
    });
}

void PlaceDialog::fill(const Pose& pose)
{
    for (int axis = 0; axis < 3; ++axis)
        place_[axis]->setValue(pose.translation[axis]);
    heading_->setValue(toDegrees(headingOf(pose)));
}

Pose PlaceDialog::pose() const
{
    const Eigen::AngleAxisd turn(degrees(heading_->value()) - headingBefore_, Eigen::Vector3d::UnitZ());
    return Pose{(turn * before_.rotation).normalized(), {place_[0]->value(), place_[1]->value(), place_[2]->value()}};
}

std::optional<Pose> PlaceDialog::place() const
{
    return isKnown_->isChecked() ? std::optional(pose()) : std::nullopt;
}

}  // namespace planewright
