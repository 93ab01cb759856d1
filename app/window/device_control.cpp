// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/window/device_control.h"

#include <utility>

#include "app/sources/device_checks.h"
#include "ui/panels/device_form.h"

namespace planewright {

namespace {

constexpr int kAfterPlugging = 500;  // [ms]

NoddingSetup noddingOf(const DeviceSetup& setup, const AcquisitionSettings& settings)
{
    NoddingSetup nodding;
    nodding.tiltUnit = setup.tiltUnit;
    nodding.plan.mode = setup.stepAndStare ? ScanPlan::Mode::StepAndStare : ScanPlan::Mode::Continuous;
    nodding.plan.firstPitch = settings.firstTilt;
    nodding.plan.pitchStep = settings.tiltStep;
    nodding.plan.slices = settings.slices;
    nodding.plan.firstBearing = degrees(setup.firstBearing);
    nodding.plan.lastBearing = degrees(setup.lastBearing);
    return nodding;
}

DeviceChoice choiceOf(const FoundDevice& device)
{
    const bool isPort = device.kind == FoundDevice::Kind::SerialPort;
    DeviceChoice choice{device.address, device.name, device.problem, false, false};
    choice.isLaser = device.kind == FoundDevice::Kind::Laser || isPort;
    choice.isTiltUnit = device.kind != FoundDevice::Kind::Laser;
    if (choice.name.empty())
        choice.name = nameOf(device.kind);
    return choice;
}

}  // namespace

DeviceControl::DeviceControl(WindowParts& parts, ScanControl& scan)
    : QObject(&parts), parts_(parts), scan_(scan), opener_(std::make_shared<DeviceOpener>(steadyClock()))
{
    plugged_.setSingleShot(true);
    plugged_.setInterval(kAfterPlugging);
    connect(&plugged_, &QTimer::timeout, this, [this] { search(false); });
    opener_->onUsbChange([this] {
        QMetaObject::invokeMethod(
            this, [this] { plugged_.start(); }, Qt::QueuedConnection);
    });
    SourcePanel& panel = *parts_.sourcePanel;
    connect(&panel, &SourcePanel::devicesShown, this, [this] { search(false); });
    connect(&panel, &SourcePanel::devicesRequested, this, &DeviceControl::connectDevices);
    connect(&panel.devices(), &DeviceForm::searchRequested, this, [this] { search(true); });
    connect(&panel.devices(), &DeviceForm::testRequested, this, &DeviceControl::test);
    connect(&parts_.session, &ScanSession::stateChanged, this, [this] {
        parts_.sourcePanel->devices().setTestable(isIdle());
        showFacts();
    });
    connect(&parts_.session, &ScanSession::statusChanged, this, &DeviceControl::showFacts);
}

DeviceControl::~DeviceControl()
{
    stop_.request_stop();
}

/// A laser that is open can neither be asked nor tested.
bool DeviceControl::isIdle() const
{
    return !work_.isBusy() && parts_.session.health().empty();
}

void DeviceControl::search(bool asks)
{
    if (work_.isBusy())
        return;
    work_.start<std::vector<FoundDevice>>([opener = opener_, asks = asks && isIdle(),
                                           stop = stop_.get_token()] { return findDevices(*opener, asks, stop); },
                                          [this](std::vector<FoundDevice>& found) {
                                              show(found);
                                              parts_.sourcePanel->devices().setTestable(isIdle());
                                          });
    parts_.sourcePanel->devices().setTestable(false);
}

void DeviceControl::show(const std::vector<FoundDevice>& found)
{
    std::vector<DeviceChoice> choices;
    for (const FoundDevice& device : found) {
        DeviceChoice choice = choiceOf(device);
        if (device.kind == FoundDevice::Kind::SerialPort) {
            // The same port may have any of the three behind it.
            choice.isTiltUnit = false;
            choices.push_back(choice);
            choice.isLaser = false;
            choice.isTiltUnit = true;
            for (const char* unit : {"dynamixel:", "board:"}) {
                choice.address = unit + device.address;
                choices.push_back(choice);
            }
            continue;
        }
        choices.push_back(std::move(choice));
    }
    parts_.sourcePanel->devices().setChoices(choices);
}

void DeviceControl::test()
{
    const DeviceSetup setup = parts_.sourcePanel->devices().setup();
    const Result<AcquisitionSettings> settings = acquisitionOf(setup);
    if (!settings || work_.isBusy())
        return;
    checks_.clear();
    for (const std::string_view check : kDeviceChecks)
        checks_.push_back({std::string(check), DeviceCheck::State::Waiting, {}});
    parts_.sourcePanel->devices().setChecks(checks_);
    const NoddingSetup nodding = noddingOf(setup, *settings);
    work_.start<bool>(
        [this, laser = setup.laser, nodding, stop = stop_.get_token()] {
            const auto progress = [this](std::size_t check, const std::optional<Result<std::string>>& result) {
                QMetaObject::invokeMethod(
                    this, [this, check, result] { takeCheck(check, result); }, Qt::QueuedConnection);
            };
            checkDevices(laser, nodding, steadyClock(), progress, stop);
            return true;
        },
        [this](bool& /*done*/) { parts_.sourcePanel->devices().setTestable(isIdle()); });
    parts_.sourcePanel->devices().setTestable(false);
}

void DeviceControl::takeCheck(std::size_t check, const std::optional<Result<std::string>>& result)
{
    DeviceCheck& row = checks_.at(check);
    row.state = !result   ? DeviceCheck::State::Running
                : *result ? DeviceCheck::State::Passed
                          : DeviceCheck::State::Failed;
    if (result)
        row.detail = *result ? **result : result->error().message;
    parts_.sourcePanel->devices().setChecks(checks_);
    if (result && !*result)
        parts_.log(LogSeverity::Error, tr("devices"), QString::fromStdString(row.detail));
}

void DeviceControl::connectDevices(const DeviceSetup& setup)
{
    const Result<AcquisitionSettings> settings = acquisitionOf(setup);
    if (!settings) {
        parts_.problem(tr("devices"), settings.error());
        return;
    }
    NoddingSetup nodding = noddingOf(setup, *settings);
    // The session, which waits for whom it opens, is one of the parts: they are there as long as anybody calls this.
    nodding.progress = [&parts = parts_](const std::string& line) {
        QMetaObject::invokeMethod(
            &parts, [&parts, line] { parts.say(QString::fromStdString(line)); }, Qt::QueuedConnection);
    };
    parts_.session.setNodding(nodding);
    scan_.open(QString::fromStdString(setup.laser));
}

void DeviceControl::showFacts()
{
    std::vector<DeviceFact> facts;
    for (const HealthFact& fact : parts_.session.health())
        facts.push_back({fact.name, fact.value, fact.isTrouble});
    parts_.sourcePanel->devices().setFacts(facts);
}

}  // namespace planewright
