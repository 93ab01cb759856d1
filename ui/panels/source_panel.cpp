// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/panels/source_panel.h"

#include <utility>

#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QStackedWidget>
#include <QVBoxLayout>

#include "ui/panels/device_form.h"
#include "ui/panels/plain_fields.h"
#include "ui/panels/problem_label.h"
#include "ui/panels/recording_form.h"
#include "ui/panels/simulator_form.h"

namespace planewright {

SourcePanel::SourcePanel(QWidget* parent)
    : QWidget(parent),
      type_(new QuietComboBox(this)),
      forms_(new QStackedWidget(this)),
      simulator_(new SimulatorForm(this)),
      recording_(new RecordingForm(this)),
      devices_(new DeviceForm(this)),
      size_(new QLabel(this)),
      problem_(new ProblemLabel(this)),
      open_(new QPushButton(this))
{
    setObjectName(QStringLiteral("sourcePanel"));
    auto* content = new QWidget(this);
    auto* layout = new QVBoxLayout(content);
    layout->setContentsMargins(8, 8, 8, 8);
    layout->setSpacing(8);
    type_->setObjectName(QStringLiteral("sourceType"));
    type_->setAccessibleName(tr("Type of source"));
    type_->addItems({tr("Simulator"), tr("Recording"), tr("Device")});
    auto* typeForm = new QFormLayout;
    typeForm->addRow(tr("&Type"), type_);
    layout->addLayout(typeForm);
    forms_->addWidget(simulator_);
    forms_->addWidget(recording_);
    forms_->addWidget(devices_);
    layout->addWidget(forms_);
    size_->setObjectName(QStringLiteral("scanSize"));
    size_->setAccessibleName(tr("Size of the scan"));
    size_->setWordWrap(true);
    layout->addWidget(size_);
    layout->addWidget(problem_);
    open_->setObjectName(QStringLiteral("openSource"));
    layout->addWidget(open_);
    layout->addStretch();

    auto* outer = new QVBoxLayout(this);
    outer->setContentsMargins({});
    outer->addWidget(scrolling(content, this));
    connect(type_, &QComboBox::currentIndexChanged, this, [this](int type) {
        forms_->setCurrentIndex(type);
        check();
        if (forms_->currentWidget() == devices_)
            emit devicesShown();
    });
    connect(simulator_, &SimulatorForm::changed, this, &SourcePanel::check);
    connect(recording_, &RecordingForm::changed, this, &SourcePanel::check);
    connect(devices_, &DeviceForm::changed, this, &SourcePanel::check);
    connect(open_, &QPushButton::clicked, this, &SourcePanel::open);
    check();
}

void SourcePanel::showSimulation(const SimulationSetup& setup)
{
    simulator_->setSetup(setup);
    type_->setCurrentIndex(forms_->indexOf(simulator_));
}

void SourcePanel::showRecording(const QString& file)
{
    recording_->setFile(file);
    type_->setCurrentIndex(forms_->indexOf(recording_));
}

void SourcePanel::showDevices(const DeviceSetup& setup)
{
    devices_->setSetup(setup);
    showDevices();
}

void SourcePanel::showDevices()
{
    type_->setCurrentIndex(forms_->indexOf(devices_));
}

SimulationSetup SourcePanel::simulation() const
{
    return simulator_->setup();
}

void SourcePanel::setRecentFiles(const QStringList& files)
{
    recording_->setRecentFiles(files);
}

void SourcePanel::check()
{
    const QWidget* form = forms_->currentWidget();
    QString problem;
    bool isUnfilled = false;  // an empty field is not wrong yet; the button waits for it
    Result<std::string> size;
    if (form == simulator_)
        size = acquisitionOf(simulator_->setup()).map(scanSizeText);
    if (form == devices_) {
        size = sizeOf(devices_->setup());
        problem = devices_->problem();
        isUnfilled = devices_->setup().laser.empty() || devices_->setup().tiltUnit.empty();
    }
    if (form == recording_) {
        problem = recording_->problem();
        isUnfilled = recording_->file().isEmpty();
    }
    if (!size && (problem.isEmpty() || isUnfilled)) {
        problem = QString::fromStdString(size.error().message);
        isUnfilled = false;
    }
    size_->setText(size ? QString::fromStdString(*size) : QString{});
    size_->setVisible(!size_->text().isEmpty());
    problem_->tell(isUnfilled ? QString{} : problem);
    open_->setEnabled(problem.isEmpty());
    open_->setText(form == simulator_   ? tr("Use this simulator")
                   : form == recording_ ? tr("Open recording")
                                        : tr("Connect"));
    open_->setAccessibleName(open_->text());
}

/// By the devices themselves where they are known, or else by what most of them are.
Result<std::string> SourcePanel::sizeOf(const DeviceSetup& setup) const
{
    const Result<AcquisitionSettings> settings = acquisitionWith(setup);
    if (!settings)
        return tl::unexpected{settings.error()};
    Result<std::string> known = deviceEstimate_ ? deviceEstimate_(setup) : std::string{};
    return known && known->empty() ? scanSizeText(*settings) : known;
}

void SourcePanel::setDeviceEstimate(DeviceEstimate estimate)
{
    deviceEstimate_ = std::move(estimate);
    check();
}

void SourcePanel::open()
{
    if (forms_->currentWidget() == simulator_)
        emit simulationRequested(simulator_->setup());
    else if (forms_->currentWidget() == devices_)
        emit devicesRequested(devices_->setup());
    else
        emit openRequested(recording_->address());
}

}  // namespace planewright
