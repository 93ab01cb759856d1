// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/window/scan_control.h"

#include <algorithm>
#include <array>
#include <utility>

#include <QApplication>
#include <QDir>
#include <QFileInfo>
#include <QStandardPaths>
#include <QStorageInfo>

namespace planewright {

namespace {

constexpr int kMostRecent = 12;
constexpr double kGigabyte = 1e9;

}  // namespace

ScanControl::ScanControl(WindowParts& parts) : QObject(&parts), parts_(parts)
{
    connectActions();
    connectSession();
    showRecent();
    takeState(parts_.session.state());
    takeStatus(parts_.session.status());
}

void ScanControl::act(const Result<void>& result)
{
    if (!result)
        parts_.say(QString::fromStdString(result.error().message));
}

void ScanControl::connectActions()
{
    WindowActions& actions = parts_.window->actions();
    ScanSession& session = parts_.session;
    const auto on = [&](const char* name, auto&& call) {
        connect(actions[QLatin1String(name)], &QAction::triggered, this, call);
    };
    on("actStart", [this] { start(); });
    on("actNextStop", [this] { startNextStop(); });
    on("actPause", [this, &session] { act(session.pauseOrContinue()); });
    on("actStep", [this, &session] { act(session.step()); });
    on("actFinish", [this, &session] { act(session.finish()); });
    on("actStopMotion", [this, &session] { act(session.stopMotion()); });
    on("actRerun", [this, &session] { act(session.rerun()); });
    on("actNewSimulated", [this] { simulate(parts_.sourcePanel->simulation()); });
    QAction* record = actions[QStringLiteral("actRecord")];
    record->setChecked(parts_.settings.value(QStringLiteral("scan/record"), false).toBool());
    connect(record, &QAction::toggled, this,
            [this](bool records) { parts_.settings.setValue(QStringLiteral("scan/record"), records); });

    connect(parts_.sourcePanel, &SourcePanel::simulationRequested, this, &ScanControl::simulate);
    connect(parts_.sourcePanel, &SourcePanel::openRequested, this, [this](const QString& address) { open(address); });
    connect(parts_.window.get(), &MainWindow::openRequested, this,
            [this](const QString& address) { open(address, true); });
    connect(&parts_.window->welcome(), &WelcomePage::sampleRequested, this,
            [this] { open(QStringLiteral("sim:corridor?seed=7"), true); });
    connect(parts_.parametersPanel, &ParametersPanel::parametersChanged, this,
            [this](const Parameters& parameters) { act(parts_.session.setParameters(parameters)); });
}

void ScanControl::connectSession()
{
    ScanSession& session = parts_.session;
    connect(&session, &ScanSession::stateChanged, this, &ScanControl::takeState);
    connect(&session, &ScanSession::statusChanged, this, &ScanControl::takeStatus);
    connect(&session, &ScanSession::motionStoppedChanged, this, &ScanControl::showMotionStopped);
    // The project of before is gone by now: nothing may go on writing to it.
    connect(&session, &ScanSession::projectChanged, this, [this] {
        parts_.selection.clear();
        parts_.edits.begin(parts_.session.project(), parts_.session.scanInProject(), parts_.session.storedEdits());
        parts_.mapEdits.begin(parts_.session.project());
        parts_.showMap();
        showFlawsOfFile();
    });
    connect(&session, &ScanSession::projectBegun, this, [this] {
        if (const auto moved = parts_.edits.moveInto(parts_.session.project(), parts_.session.scanInProject()); !moved)
            parts_.problem(tr("edits"), moved.error());
        parts_.mapEdits.begin(parts_.session.project());
    });
    connect(&session, &ScanSession::mapChanged, this, [this] { parts_.showMap(); });
    connect(&parts_, &WindowParts::mapShown, this, &ScanControl::refreshOverlay);
    connect(&session, &ScanSession::parametersChanged, this, [this] {
        const QSignalBlocker quiet(parts_.parametersPanel);
        parts_.parameters.setParameters(parts_.session.parameters());
        parts_.planesPanel->setParameters(parts_.extractedWith());
    });
    connect(&session, &ScanSession::historyChanged, this, [this] {
        const std::vector<ExtractedStep>& steps = parts_.session.history();
        const auto parameters = steps.empty() ? nullptr : steps.back().parameters;
        if (std::exchange(tableParameters_, parameters) != parameters)
            parts_.planesPanel->setParameters(parts_.extractedWith());
    });
    connect(&session, &ScanSession::logLine, this, [this](LogLevel level, const QString& source, const QString& text) {
        parts_.log(level == LogLevel::Error     ? LogSeverity::Error
                   : level == LogLevel::Warning ? LogSeverity::Warning
                                                : LogSeverity::Info,
                   source, text);
    });
    connect(&session, &ScanSession::faulted, this, [this](const Error& error) {
        const QString text = QString::fromStdString(error.message);
        parts_.fault = error;
        parts_.log(LogSeverity::Error, tr("session"), text);
        if (parts_.preferences.alarmSound)
            QApplication::beep();
        showFault(text);
    });
}

void ScanControl::showFault(const QString& text)
{
    std::vector<Banner::Choice> choices;
    const bool isFault = parts_.session.state() == SessionState::Fault;
    if (parts_.session.isMotionStopped())
        choices.emplace_back(tr("Release"), [this] { act(parts_.session.release()); });
    else if (isFault)
        choices.emplace_back(tr("Retry now"), [this] { act(parts_.session.retry()); });
    if (isFault)
        choices.emplace_back(tr("Finish with what we have"), [this] { act(parts_.session.finish()); });
    parts_.window->banner().showMessage(Banner::Kind::Problem, text, choices);
}

/// Stays until somebody releases what was stopped: no scan begins or goes on before.
void ScanControl::showMotionStopped(bool isStopped)
{
    refreshActions();
    refreshOverlay();
    if (isStopped)
        showFault(tr("Motion was stopped. Nothing moves before you release it."));
    else if (parts_.session.state() == SessionState::Fault && parts_.fault)
        showFault(QString::fromStdString(parts_.fault->message));
    else
        parts_.window->banner().hide();
}

/// What a file that was opened lacks, and why it cannot be changed where that is no matter of where it lies.
void ScanControl::showFlawsOfFile()
{
    QStringList sentences;
    const auto& damage = parts_.session.damage();
    if (damage && damage->slicesLeftOut > 0)
        sentences << (damage->slicesLeftOut == 1 ? tr("%1 of %2 slices was damaged and left out.")
                                                 : tr("%1 of %2 slices were damaged and left out."))
                         .arg(damage->slicesLeftOut)
                         .arg(damage->slices + damage->slicesLeftOut);
    else if (damage)
        sentences << tr("The file is damaged; what is sound of it is shown.");
    const PwscanProject* project = parts_.session.project();
    if (project != nullptr && project->readOnlyCause() == ReadOnlyCause::NewerVersion)
        sentences << tr(
            "The recording was written by a newer version of the program: it can be looked at and "
            "exported here, and changed there.");
    if (sentences.isEmpty())
        return;
    std::vector<Banner::Choice> choices;
    if (damage)
        choices.emplace_back(tr("Show the log"),
                             [this] { parts_.window->showBottomPanel(QStringLiteral("logPanel")); });
    parts_.window->banner().showMessage(damage ? Banner::Kind::Problem : Banner::Kind::Notice,
                                        sentences.join(QLatin1Char(' ')), choices);
}

void ScanControl::open(const QString& fileOrAddress, bool starts)
{
    simulated_.reset();
    openWith(SessionOptions{}.simulation, fileOrAddress, starts);
}

void ScanControl::simulate(const SimulationSetup& setup)
{
    SimulatedScanner simulation;
    const auto settings = acquisitionOf(setup);
    const auto noise = simulationNoise(setup.noise);
    if (!settings || !noise) {
        parts_.problem(tr("simulator"), !settings ? settings.error() : noise.error());
        return;
    }
    simulation.settings = *settings;
    simulation.noise = *noise;
    simulated_ = setup;
    openRoom(simulation, QString::fromStdString(addressOf(setup)));
}

void ScanControl::openWith(const SimulatedScanner& simulation, const QString& fileOrAddress, bool starts)
{
    startsWhenReady_ = starts && fileOrAddress.startsWith(QLatin1String("sim:"));
    parts_.fault.reset();
    parts_.session.setSimulation(simulation);
    const std::string text = fileOrAddress.toStdString();
    Result<void> opened = parts_.beforeOpen ? parts_.beforeOpen(text) : Result<void>{};
    if (opened)
        opened = parts_.session.open(text);
    if (!opened) {
        parts_.fault = opened.error();
        parts_.problem(tr("open"), opened.error());
        return;
    }
    parts_.window->banner().hide();
    parts_.window->showWelcome(false);
    if (QFileInfo(fileOrAddress).isFile())
        addRecent(QFileInfo(fileOrAddress).absoluteFilePath());
}

bool ScanControl::mayMove()
{
    if (parts_.session.isMotionStopped())
        showMotionStopped(true);
    return !parts_.session.isMotionStopped();
}

void ScanControl::start()
{
    mayMove();
    prepareRecording();
    act(parts_.session.start());
}

void ScanControl::startNextStop()
{
    mayMove();
    const QFileInfo file(QString::fromStdString(parts_.session.status().recording));
    if (hasRoomIn(file.absolutePath()))
        act(parts_.session.startNextStop());
}

/// Whether a scan may be recorded into a folder, with a word about it where too little space is left.
bool ScanControl::hasRoomIn(const QString& folder)
{
    const double floor = parts_.preferences.freeSpaceFloor;
    const QStorageInfo disk(folder);
    const double free = static_cast<double>(disk.bytesAvailable()) / kGigabyte;
    if (!disk.isValid() || free >= floor)
        return true;
    const QString text = tr("This scan is not recorded: %1 has %2 GB left, and the preferences ask for %3 GB. Make "
                            "room, or choose another folder there.")
                             .arg(folder)
                             .arg(free, 0, 'f', 2)
                             .arg(floor, 0, 'f', 1);
    parts_.log(LogSeverity::Warning, tr("recorder"), text);
    parts_.window->banner().showMessage(Banner::Kind::Problem, text);
    return false;
}

/// Where the next scan is recorded; nowhere where too little space is left.
void ScanControl::prepareRecording()
{
    parts_.session.setRecordFolder({});
    if (!parts_.window->actions()[QStringLiteral("actRecord")]->isChecked())
        return;
    QString folder = QString::fromStdString(parts_.preferences.recordFolder);
    if (folder.isEmpty())
        folder = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation) + "/Planewright";
    QDir().mkpath(folder);
    if (hasRoomIn(folder))
        parts_.session.setRecordFolder(folder.toStdString());
}

void ScanControl::addRecent(const QString& file)
{
    QStringList recent = parts_.settings.value(QStringLiteral("recent")).toStringList();
    recent.removeAll(file);
    recent.prepend(file);
    parts_.settings.setValue(QStringLiteral("recent"), QStringList(recent.mid(0, kMostRecent)));
    showRecent();
}

void ScanControl::showRecent()
{
    const QStringList recent = parts_.settings.value(QStringLiteral("recent")).toStringList();
    parts_.window->welcome().setRecent(recent);
    parts_.sourcePanel->setRecentFiles(recent);
    QMenu* menu = parts_.window->actions().submenu(QStringLiteral("recent"));
    menu->clear();
    for (const QString& file : recent)
        connect(menu->addAction(QDir::toNativeSeparators(file)), &QAction::triggered, this,
                [this, file] { open(file); });
    menu->setEnabled(!recent.isEmpty());
}

void ScanControl::takeState(SessionState state)
{
    if (state == SessionState::Empty)
        parts_.window->showWelcome(true);
    parts_.window->setSource(QString::fromStdString(parts_.session.status().source));
    if (state == SessionState::Ready && startsWhenReady_) {
        startsWhenReady_ = false;
        start();
        return;
    }
    parts_.parametersPanel->setScanning(state == SessionState::Homing || state == SessionState::Scanning ||
                                        state == SessionState::Paused || state == SessionState::Finishing ||
                                        state == SessionState::Replaying || state == SessionState::Fault);
    refreshActions();
    refreshOverlay();
}

void ScanControl::refreshActions()
{
    struct Row {
        const char* action;
        SessionRequest request;
    };
    constexpr Row kRows[]{{"actStart", SessionRequest::Start},
                          {"actStep", SessionRequest::Step},
                          {"actFinish", SessionRequest::Finish},
                          {"actRerun", SessionRequest::Rerun}};
    WindowActions& actions = parts_.window->actions();
    for (const Row& row : kRows)
        actions[QLatin1String(row.action)]->setEnabled(parts_.session.refusal(row.request).isEmpty());
    actions[QStringLiteral("actNextStop")]->setEnabled(parts_.session.nextStopRefusal().isEmpty());
    // It then says why nothing moves.
    if (parts_.session.isMotionStopped())
        actions[QStringLiteral("actStart")]->setEnabled(true);
    const bool pauses = parts_.session.refusal(SessionRequest::Pause).isEmpty();
    const bool continues = parts_.session.refusal(SessionRequest::Continue).isEmpty();
    QAction* pause = actions[QStringLiteral("actPause")];
    pause->setEnabled(pauses || continues);
    pause->setIconText(continues ? tr("▶ Continue") : tr("❚❚ Pause"));
}

}  // namespace planewright
