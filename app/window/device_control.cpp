// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/window/device_control.h"

#include <cmath>

#include <QEvent>
#include <QLabel>
#include <QSignalBlocker>

#include "app/sources/scan_size.h"
#include "app/window/device_settings.h"
#include "ui/panels/device_form.h"

namespace planewright {

namespace {

constexpr int kLookEvery = 500;      // [ms]
constexpr int kNarrowestLine = 120;  // [px]

NoddingSetup noddingOf(const DeviceSetup& setup, const AcquisitionSettings& settings)
{
    NoddingSetup nodding;
    nodding.tiltUnit = tiltUnitAddress(setup);
    nodding.dialogueFolder = setup.dialogueFolder;
    nodding.plan.mode = setup.stepAndStare ? ScanPlan::Mode::StepAndStare : ScanPlan::Mode::Continuous;
    nodding.plan.firstPitch = settings.firstTilt;
    nodding.plan.pitchStep = settings.tiltStep;
    nodding.plan.slices = settings.slices;
    nodding.plan.firstBearing = degrees(setup.firstBearing);
    nodding.plan.lastBearing = degrees(setup.lastBearing);
    nodding.plan.cluster = setup.cluster;
    nodding.plan.pitchAxisOffset = setup.axisOffset;
    nodding.plan.settle = std::chrono::milliseconds{std::lround(setup.settle)};
    nodding.plan.travelSpeed = degrees(setup.travelSpeed);
    return nodding;
}

DeviceChoice choiceOf(const FoundDevice& device)
{
    const bool isPort = device.kind == FoundDevice::Kind::SerialPort;
    DeviceChoice choice{device.address, device.name, device.problem, false, false, device.cure};
    choice.isLaser = device.kind == FoundDevice::Kind::Laser || isPort;
    choice.isTiltUnit = device.kind != FoundDevice::Kind::Laser;
    if (choice.name.empty())
        choice.name = nameOf(device.kind);
    return choice;
}

}  // namespace

DeviceControl::DeviceControl(WindowParts& parts, ScanControl& scan)
    : QObject(&parts),
      parts_(parts),
      scan_(scan),
      opener_(std::make_shared<DeviceOpener>(steadyClock())),
      search_([opener = opener_](bool asks, const KnownLasers& known, const std::stop_token& stop) {
          return findDevices(*opener, asks, known, stop);
      })
{
    opener_->onUsbChange([this] {
        QMetaObject::invokeMethod(
            this, [this] { search_.noteChange(); }, Qt::QueuedConnection);
    });
    parts_.sourcePanel->devices().setSetup(loadDeviceSetup(parts_.settings));
    search_.setKnown(loadKnownLasers(parts_.settings));
    connectForm();
    connectActions();
    connectTrials();
    parts_.sourcePanel->setDeviceEstimate([this](const DeviceSetup& setup) { return estimate(setup); });
    connect(&search_, &DeviceSearch::begun, this, &DeviceControl::refresh);
    connect(&search_, &DeviceSearch::found, this, &DeviceControl::show);
    connect(&parts_.session, &ScanSession::stateChanged, this, &DeviceControl::refresh);
    connect(&parts_.session, &ScanSession::motionStoppedChanged, this, &DeviceControl::refresh);
    connectHealth();
}

DeviceControl::~DeviceControl()
{
    saveDeviceSetup(parts_.sourcePanel->devices().setup(), parts_.settings);
    parts_.sourcePanel->setDeviceEstimate({});
    parts_.beforeOpen = {};
    parts_.isTrying = {};
}

void DeviceControl::connectForm()
{
    SourcePanel& panel = *parts_.sourcePanel;
    connect(&panel, &SourcePanel::devicesShown, this, [this] { search(false); });
    connect(&panel, &SourcePanel::devicesRequested, this, &DeviceControl::connectDevices);
    connect(&parts_.window->welcome(), &WelcomePage::connectRequested, &parts_, &WindowParts::showDevices);
    connect(&panel.devices(), &DeviceForm::searchRequested, this, [this] { search(true); });
    connect(&panel.devices(), &DeviceForm::testRequested, this, &DeviceControl::test);
    connect(&panel.devices(), &DeviceForm::homeRequested, this, &DeviceControl::home);
    connect(&panel.devices(), &DeviceForm::changed, this, &DeviceControl::refreshActions);
    connect(&panel.devices(), &DeviceForm::recoverRequested, this, &DeviceControl::recover);
}

void DeviceControl::connectActions()
{
    const auto on = [&](const char* name, auto&& call) {
        connect(parts_.window->actions()[QLatin1String(name)], &QAction::triggered, this, call);
    };
    on("actHome", [this] { home(); });
    on("actConnect", [this] {
        if (showFilledForm())
            connectDevices(parts_.sourcePanel->devices().setup());
    });
    on("actTestDevices", [this] {
        if (showFilledForm())
            test();
    });
    on("actFindDevices", [this] {
        parts_.showDevices();
        search(true);
    });
    on("actRecover", [this] {
        if (parts_.session.isMotionStopped())
            static_cast<void>(parts_.session.release());
        else
            recover();
    });
    parts_.beforeOpen = [this](const std::string& fileOrAddress) { return prepare(fileOrAddress); };
    parts_.isTrying = [this] { return search_.isBusy() || trials_.isBusy(); };
}

bool DeviceControl::showFilledForm()
{
    {
        // What looks for devices could not test them meanwhile.
        const QSignalBlocker quiet(parts_.sourcePanel);
        parts_.showDevices();
    }
    const QString problem = parts_.sourcePanel->devices().problem();
    if (!problem.isEmpty())
        parts_.say(problem);
    return problem.isEmpty();
}

void DeviceControl::connectTrials()
{
    connect(parts_.window->actions()[QStringLiteral("actStopMotion")], &QAction::triggered, &trials_,
            &DeviceTrials::stopMotion);
    connect(&trials_, &DeviceTrials::busyChanged, this, [this] {
        search_.setHeld(trials_.isBusy());
        refresh();
    });
    connect(&trials_, &DeviceTrials::checksChanged, &parts_.sourcePanel->devices(), &DeviceForm::setChecks);
    connect(&trials_, &DeviceTrials::failed, this, [this](const Error& error) {
        parts_.log(LogSeverity::Error, tr("devices"), QString::fromStdString(error.message));
        if (error.code == ErrorCode::NeedsOperator)
            parts_.sourcePanel->devices().setRecoverable(true);
    });
    connect(&trials_, &DeviceTrials::passed, this, [this] { parts_.sourcePanel->devices().setRecoverable(false); });
}

/// A laser that is open can neither be asked nor tested.
bool DeviceControl::isIdle() const
{
    return !search_.isBusy() && !trials_.isBusy() && parts_.session.health().empty();
}

Result<std::string> DeviceControl::estimate(const DeviceSetup& setup) const
{
    const Result<AcquisitionSettings> settings = acquisitionWith(setup);
    const bool areTheSame =
        scanner_ && setup.laser == connected_.laser && tiltUnitAddress(setup) == tiltUnitAddress(connected_);
    if (!settings || !areTheSame)
        return std::string{};
    const ScanPlan plan = noddingOf(setup, *settings).plan;
    return fitPlanTo(*scanner_, plan).map([&](const FittedPlan& fitted) { return scanSizeText(fitted, plan.slices); });
}

void DeviceControl::refresh()
{
    if (parts_.session.scanner())
        scanner_ = parts_.session.scanner();
    parts_.sourcePanel->devices().setTestable(isIdle());
    parts_.sourcePanel->devices().setConnectedHead(hasConnectedHead());
    showFacts();
}

/// Where motion is stopped it says so.
bool DeviceControl::hasConnectedHead() const
{
    const SessionState state = parts_.session.state();
    const bool isStopped = parts_.session.isMotionStopped() && !parts_.session.health().empty() &&
                           (state == SessionState::Ready || state == SessionState::Review);
    return parts_.session.canGoHome() || isStopped;
}

void DeviceControl::refreshActions()
{
    const WindowActions& actions = parts_.window->actions();
    const DeviceForm& form = parts_.sourcePanel->devices();
    actions[QStringLiteral("actHome")]->setEnabled(form.canGoHome());
    actions[QStringLiteral("actTestDevices")]->setEnabled(form.isTestable());
    actions[QStringLiteral("actFindDevices")]->setEnabled(form.isTestable());
    actions[QStringLiteral("actRecover")]->setEnabled(parts_.session.isMotionStopped() || form.canRecover());
}

void DeviceControl::search(bool asks)
{
    search_.start(asks && parts_.session.health().empty());
}

void DeviceControl::show(const FoundDevices& found)
{
    saveKnownLasers(search_.known(), parts_.settings);
    std::vector<DeviceChoice> choices;
    for (const FoundDevice& device : found.devices) {
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
    DeviceForm& form = parts_.sourcePanel->devices();
    form.setSearchProblem(QString::fromStdString(found.usbProblem));
    form.setChoices(choices);
    refresh();
}

void DeviceControl::test()
{
    const DeviceSetup setup = parts_.sourcePanel->devices().setup();
    const Result<AcquisitionSettings> settings = acquisitionWith(setup);
    if (settings && isIdle() && scan_.mayMove())
        trials_.test(setup.laser, noddingOf(setup, *settings));
}

/// What is connected, or else what is chosen.
void DeviceControl::home()
{
    if (!scan_.mayMove())
        return;
    if (hasConnectedHead())
        static_cast<void>(parts_.session.goHome());
    else if (isIdle())
        trials_.home(tiltUnitAddress(parts_.sourcePanel->devices().setup()));
}

void DeviceControl::recover()
{
    if (isIdle())
        trials_.recover(tiltUnitAddress(parts_.sourcePanel->devices().setup()));
}

void DeviceControl::connectDevices(const DeviceSetup& setup)
{
    saveDeviceSetup(setup, parts_.settings);
    scan_.open(QString::fromStdString(setup.laser));
}

/// The tilt unit and the plan are those of the form, whoever names the laser.
Result<void> DeviceControl::prepare(const std::string& fileOrAddress)
{
    const auto address = parseSourceAddress(fileOrAddress);
    if (!address || address->kind != SourceAddress::Kind::Laser)
        return {};
    DeviceSetup setup = parts_.sourcePanel->devices().setup();
    setup.laser = fileOrAddress;
    if (setup.tiltUnit.empty()) {
        parts_.sourcePanel->showDevices(setup);
        parts_.showDevices();
        return fail(ErrorCode::Usage,
                    tr("%1: a laser needs a tilt unit to scan with; choose it in Setup, Source, Device.")
                        .arg(QString::fromStdString(fileOrAddress))
                        .toStdString());
    }
    const Result<AcquisitionSettings> settings = acquisitionWith(setup);
    if (!settings)
        return tl::unexpected{settings.error()};
    NoddingSetup nodding = noddingOf(setup, *settings);
    // The session, which waits for whom it opens, is one of the parts: they are there as long as anybody calls this.
    nodding.progress = [&parts = parts_](const std::string& line) {
        QMetaObject::invokeMethod(
            &parts, [&parts, line] { parts.say(QString::fromStdString(line)); }, Qt::QueuedConnection);
    };
    connected_ = setup;
    scanner_.reset();
    parts_.session.setNodding(nodding);
    return {};
}

void DeviceControl::connectHealth()
{
    auto* line = parts_.window->findChild<QLabel*>(QStringLiteral("stHealth"));
    line->setCursor(Qt::PointingHandCursor);
    line->setMinimumWidth(kNarrowestLine);  // a long trouble must not make the window wider
    line->installEventFilter(this);
    healthTimer_.setInterval(kLookEvery);
    connect(&healthTimer_, &QTimer::timeout, this, &DeviceControl::showFacts);
    healthTimer_.start();
    connect(&parts_.session, &ScanSession::statusChanged, this, &DeviceControl::showFacts);
    refresh();
}

bool DeviceControl::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::MouseButtonRelease)
        parts_.showDevices();
    return QObject::eventFilter(watched, event);
}

void DeviceControl::showFacts()
{
    const std::vector<HealthFact> health = parts_.session.health();
    std::vector<DeviceFact> facts;
    for (const HealthFact& fact : health)
        facts.push_back({fact.name, fact.value, fact.isTrouble});
    parts_.sourcePanel->devices().setFacts(facts);
    showLine(health);
}

/// Always in sight while devices are connected.
void DeviceControl::showLine(const std::vector<HealthFact>& health)
{
    QStringList line;
    bool warns = false;
    for (const HealthFact& fact : health) {
        warns = warns || fact.isTrouble;
        if (!fact.brief.empty())
            line += QString::fromStdString(fact.brief);
    }
    const QString text = line.join(QStringLiteral(", "));
    parts_.window->setStatus(QStringLiteral("stHealth"), text, tr("%1\nA click shows more.").arg(text), warns);
    parts_.window->findChild<QLabel*>(QStringLiteral("stHealth"))->setVisible(!line.isEmpty());
}

}  // namespace planewright
