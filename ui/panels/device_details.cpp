// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/panels/device_details.h"

#include <QFileDialog>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

#include "ui/panels/plain_fields.h"

namespace planewright {

DeviceDetails::DeviceDetails(QWidget* parent)
    : QWidget(parent), header_(new QToolButton(this)), body_(new QWidget(this)), dialogues_(new QLineEdit(this))
{
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins({});
    header_->setObjectName(QStringLiteral("deviceDetails"));
    header_->setText(tr("Limits and mounting"));
    header_->setAccessibleName(header_->text());
    header_->setToolTip(tr("What is set once for a rig"));
    header_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    header_->setAutoRaise(true);
    header_->setCheckable(true);
    header_->setMinimumHeight(28);
    layout->addWidget(header_);
    layout->addWidget(body_);
    auto* form = new QFormLayout(body_);
    form->setContentsMargins({});
    form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);

    cluster_ = addNumber(form, tr("Joined steps"), QStringLiteral("deviceCluster"), {}, 1.0, 99.0,
                         tr("Steps of the laser that give one range together, the least of them: for coarser scans"));
    cluster_->setDecimals(0);
    lowest_ = addNumber(form, tr("Lowest tilt"), QStringLiteral("deviceLowest"), tr("°"), -360.0, 360.0,
                        tr("The head never goes below this angle; 90° looks level"));
    highest_ = addNumber(form, tr("Highest tilt"), QStringLiteral("deviceHighest"), tr("°"), -360.0, 360.0,
                         tr("The head never goes above this angle"));
    fastest_ = addNumber(form, tr("Speed limit"), QStringLiteral("deviceFastest"), tr(" °/s"), 1.0, 720.0,
                         tr("The head never turns faster"));
    travelSpeed_ = addNumber(form, tr("Travel speed"), QStringLiteral("deviceTravelSpeed"), tr(" °/s"), 1.0, 720.0,
                             tr("To where a scan begins, and from step to step"));
    settle_ = addNumber(form, tr("Settle time"), QStringLiteral("deviceSettle"), tr(" ms"), 0.0, 10'000.0,
                        tr("Rest before each slice of Step and stare, for heads that shake"));
    settle_->setDecimals(0);
    axisOffset_ = addNumber(form, tr("Lever arm"), QStringLiteral("deviceAxisOffset"), tr(" m"), -1.0, 1.0,
                            tr("d_l: from the axis of the tilt to the origin of the laser, to be measured once"));
    addFolder(form);

    connect(header_, &QToolButton::toggled, this, [this](bool open) {
        body_->setVisible(open);
        header_->setArrowType(open ? Qt::DownArrow : Qt::RightArrow);
    });
    setOpen(true);
    setOpen(false);
}

void DeviceDetails::setOpen(bool open)
{
    header_->setChecked(open);
}

QDoubleSpinBox* DeviceDetails::addNumber(QFormLayout* form, const QString& label, const QString& name,
                                         const QString& unit, double lowest, double highest, const QString& tip)
{
    auto* box = new PlainSpinBox(body_);
    box->setObjectName(name);
    box->setAccessibleName(label);
    box->setDecimals(3);
    box->setRange(lowest, highest);
    box->setSuffix(unit);
    box->setToolTip(tip);
    form->addRow(label, box);
    connect(box, &QDoubleSpinBox::valueChanged, this, &DeviceDetails::changed);
    return box;
}

void DeviceDetails::addFolder(QFormLayout* form)
{
    dialogues_->setParent(body_);
    dialogues_->setObjectName(QStringLiteral("deviceDialogues"));
    dialogues_->setAccessibleName(tr("Folder of dialogues"));
    dialogues_->setPlaceholderText(tr("not kept"));
    dialogues_->setToolTip(tr("A folder in which every byte to and from the devices is kept, for a report about one"));
    auto* browse = new QPushButton(tr("…"), body_);
    browse->setObjectName(QStringLiteral("browseDialogues"));
    browse->setAccessibleName(tr("Browse for a folder of dialogues"));
    browse->setToolTip(browse->accessibleName());
    browse->setFixedWidth(36);
    auto* line = new QHBoxLayout;
    line->addWidget(dialogues_, 1);
    line->addWidget(browse);
    form->addRow(tr("Dialogues"), line);
    connect(dialogues_, &QLineEdit::textChanged, this, &DeviceDetails::changed);
    connect(browse, &QPushButton::clicked, this, [this] {
        const QString folder =
            QFileDialog::getExistingDirectory(window(), tr("Folder of dialogues"), dialogues_->text());
        if (!folder.isEmpty())
            dialogues_->setText(folder);
    });
}

void DeviceDetails::writeTo(DeviceSetup& setup) const
{
    setup.cluster = static_cast<int>(cluster_->value());
    setup.lowest = lowest_->value();
    setup.highest = highest_->value();
    setup.fastest = fastest_->value();
    setup.travelSpeed = travelSpeed_->value();
    setup.settle = settle_->value();
    setup.axisOffset = axisOffset_->value();
    setup.dialogueFolder = dialogues_->text().trimmed().toStdString();
}

void DeviceDetails::setSetup(const DeviceSetup& setup)
{
    cluster_->setValue(setup.cluster);
    lowest_->setValue(setup.lowest);
    highest_->setValue(setup.highest);
    fastest_->setValue(setup.fastest);
    travelSpeed_->setValue(setup.travelSpeed);
    settle_->setValue(setup.settle);
    axisOffset_->setValue(setup.axisOffset);
    dialogues_->setText(QString::fromStdString(setup.dialogueFolder));
}

QString DeviceDetails::problem() const
{
    if (lowest_->value() < highest_->value())
        return {};
    return tr("Limits: give a lowest tilt below the highest.");
}

}  // namespace planewright
