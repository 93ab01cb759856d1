// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/panels/clip_box_panel.h"

#include <QCheckBox>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>

#include "ui/panels/plain_fields.h"

namespace planewright {

namespace {

constexpr double kFarthest = 1000.0;  // [m]
constexpr double kStep = 0.1;         // [m]
constexpr std::array<const char*, 3> kAxes{"X", "Y", "Z"};

QDoubleSpinBox* coordinate(const QString& name, const QString& words, QWidget* parent)
{
    auto* box = new PlainSpinBox(parent);
    box->setObjectName(name);
    box->setAccessibleName(words);
    box->setRange(-kFarthest, kFarthest);
    box->setDecimals(2);
    box->setSingleStep(kStep);
    box->setSuffix(QStringLiteral(" m"));
    return box;
}

}  // namespace

ClipBoxPanel::ClipBoxPanel(QWidget* parent)
    : QWidget(parent), inUse_(new QCheckBox(tr("Clip &box"), this)), fit_(new QPushButton(tr("Around all"), this))
{
    setObjectName(QStringLiteral("clipBoxPanel"));
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(8, 0, 8, 8);
    grid->setColumnStretch(1, 1);
    grid->setColumnStretch(2, 1);
    inUse_->setObjectName(QStringLiteral("clipBoxInUse"));
    inUse_->setToolTip(tr("Show only what is in a box (B)"));
    grid->addWidget(inUse_, 0, 0, 1, 2);
    fit_->setObjectName(QStringLiteral("clipBoxFit"));
    fit_->setToolTip(tr("Let the box go round all of the scan"));
    grid->addWidget(fit_, 0, 2);
    for (std::size_t axis = 0; axis < kAxes.size(); ++axis) {
        const QString name = QLatin1String(kAxes[axis]);
        from_[axis] = coordinate(QStringLiteral("clipFrom%1").arg(name), tr("Clip box, %1 from").arg(name), this);
        to_[axis] = coordinate(QStringLiteral("clipTo%1").arg(name), tr("Clip box, %1 to").arg(name), this);
        const int row = static_cast<int>(axis) + 1;
        auto* label = new QLabel(name, this);
        label->setBuddy(from_[axis]);
        grid->addWidget(label, row, 0);
        grid->addWidget(from_[axis], row, 1);
        grid->addWidget(to_[axis], row, 2);
        for (const QDoubleSpinBox* field : {from_[axis], to_[axis]})
            connect(field, &QDoubleSpinBox::valueChanged, this, [this] { emit boxChanged(box()); });
    }
    connect(inUse_, &QCheckBox::toggled, this, [this](bool on) {
        refresh();
        emit useRequested(on);
    });
    connect(fit_, &QPushButton::clicked, this, &ClipBoxPanel::fitRequested);
    refresh();
}

void ClipBoxPanel::refresh()
{
    for (std::size_t axis = 0; axis < kAxes.size(); ++axis) {
        from_[axis]->setEnabled(inUse_->isChecked());
        to_[axis]->setEnabled(inUse_->isChecked());
    }
    fit_->setEnabled(inUse_->isChecked());
}

void ClipBoxPanel::setInUse(bool inUse)
{
    const QSignalBlocker quiet(inUse_);
    inUse_->setChecked(inUse);
    refresh();
}

void ClipBoxPanel::setBox(const Eigen::AlignedBox3d& box)
{
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
        const auto place = static_cast<std::size_t>(axis);
        const QSignalBlocker quietFrom(from_[place]);
        const QSignalBlocker quietTo(to_[place]);
        from_[place]->setValue(box.min()[axis]);
        to_[place]->setValue(box.max()[axis]);
    }
}

Eigen::AlignedBox3d ClipBoxPanel::box() const
{
    const auto corner = [](const std::array<QDoubleSpinBox*, 3>& fields) {
        return Eigen::Vector3d{fields[0]->value(), fields[1]->value(), fields[2]->value()};
    };
    return {corner(from_), corner(to_)};
}

}  // namespace planewright
