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

#include "ui/panels/device_details.h"
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
      open_(new QPushButton(this)),
      unused_(new QLabel(this))
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
    layout->addStretch();

    auto* outer = new QVBoxLayout(this);
    outer->setContentsMargins({});
    outer->setSpacing(0);
    outer->addWidget(scrolling(content, this), 1);
    outer->addWidget(makeFoot());
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

QWidget* SourcePanel::makeFoot()
{
    auto* foot = new QWidget(this);
    auto* layout = new QVBoxLayout(foot);
    layout->setContentsMargins(8, 6, 8, 8);
    layout->setSpacing(6);
    layout->addWidget(problem_);
    unused_->setObjectName(QStringLiteral("notInUse"));
    unused_->setAccessibleName(tr("Not in use yet"));
    unused_->setWordWrap(true);
    unused_->hide();
    layout->addWidget(unused_);
    layout->addWidget(devices_->buttons());
    open_->setObjectName(QStringLiteral("openSource"));
    layout->addWidget(open_);
    return foot;
}

void SourcePanel::setOpened(const QString& name)
{
    openedName_ = name;
    opened_ = said();
    check();
}

/// Only of the form in sight: the others wait for their turn.
SourcePanel::Said SourcePanel::said() const
{
    Said said;
    said.form = forms_->currentIndex();
    if (forms_->currentWidget() == simulator_)
        said.simulation = simulator_->setup();
    else if (forms_->currentWidget() == recording_)
        said.recording = recording_->address();
    else
        said.devices = devices_->setup();
    return said;
}

void SourcePanel::showSimulation(const SimulationSetup& setup)
{
    simulator_->setSetup(setup);
    type_->setCurrentIndex(forms_->indexOf(simulator_));
}

void SourcePanel::showRecording(const QString& file, std::optional<double> speed)
{
    recording_->setFile(file);
    recording_->setPlayed(speed);
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
    problem_->tell(!isUnfilled ? problem : form == devices_ ? devices_->details().problem() : QString{});
    devices_->buttons()->setVisible(form == devices_);
    const bool isUnused = !openedName_.isEmpty() && said() != opened_;
    unused_->setText(
        isUnused ? tr("<b>Not in use yet.</b> What is open, and scanned, is %1.").arg(openedName_.toHtmlEscaped())
                 : QString{});
    unused_->setVisible(isUnused);
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
