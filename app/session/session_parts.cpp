// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/session/session_parts.h"

#include <algorithm>
#include <filesystem>
#include <limits>
#include <system_error>
#include <utility>

#include <QDateTime>

#include "app/session/loops/pwscan_recorder.h"
#include "app/session/recording_name.h"
#include "app/session/session_parameters.h"
#include "core/types/angle_text.h"

namespace planewright {

namespace {

/// After so many tries somebody is asked.
constexpr AutomaticRecovery kRecovery{3, std::numeric_limits<int>::max()};

/// "0.5 s".
std::string inSeconds(std::chrono::milliseconds time)
{
    return QString::number(std::chrono::duration<double>(time).count()).toStdString() + " s";
}

}  // namespace

SessionParts::SessionParts(ScanSession& owner, SessionOptions chosen)
    : session(owner),
      options(std::move(chosen)),
      clock(options.clock != nullptr ? *options.clock : steadyClock()),
      opener(clock),
      parameters(defaultParameters({}, {})),
      map(history.newest())
{
    frame_.setSingleShot(true);
    QObject::connect(&frame_, &QTimer::timeout, &session, [this] { onFrame(); });
    statusTick_.setInterval(options.statusEvery);
    QObject::connect(&statusTick_, &QTimer::timeout, &session, [this] { emit session.statusChanged(status()); });
    QObject::connect(&opener, &SourceOpener::opened, &session,
                     [this](const std::shared_ptr<Result<OpenedSource>>& result) { onOpened(*result); });
}

Result<void> SessionParts::request(SessionRequest request)
{
    Q_ASSERT(QThread::currentThread() == session.thread());
    return machine.request(request);
}

void SessionParts::happen(SessionHappening happening)
{
    machine.happen(happening);
    tellState();
}

void SessionParts::tellState()
{
    minds();
    if (std::exchange(toldStopped_, machine.isMotionStopped()) != machine.isMotionStopped())
        emit session.motionStoppedChanged(machine.isMotionStopped());
    if (std::exchange(told_, machine.state()) == machine.state())
        return;
    emit session.stateChanged(machine.state());
    emit session.statusChanged(status());
}

/// Devices are looked after while no scan does it. One that has no health to tell of has no devices.
void SessionParts::minds()
{
    if (!machine.isIdle() || !opened.source || opened.source->health().empty()) {
        idle.reset();
        return;
    }
    if (idle)
        return;
    idle = std::make_unique<IdleRun>(opened.source, clock);
    QObject::connect(idle.get(), &IdleRun::cameHome, &session, [this](std::optional<double> pitch) {
        happen(SessionHappening::Home);
        if (pitch)
            log(LogLevel::Info, "the head is held at " + degreesText(*pitch, 1));
    });
    QObject::connect(idle.get(), &IdleRun::homeFailed, &session, [this](const Error& error) {
        happen(SessionHappening::Home);
        if (error.code != ErrorCode::Interrupted)
            tellFault(error);
    });
    QObject::connect(idle.get(), &IdleRun::devicesTroubled, &session,
                     [this](const std::vector<FaultRecord>& records) { logRecords(records); });
}

void SessionParts::logRecords(const std::vector<FaultRecord>& records)
{
    for (const FaultRecord& record : records)
        log(LogLevel::Warning, recordText(record));
}

void SessionParts::log(LogLevel level, const std::string& text)
{
    const std::string name = opened.source ? opened.source->name() : "Session";
    emit session.logLine(level, QString::fromStdString(name), QString::fromStdString(text));
}

void SessionParts::tellFault(const Error& error)
{
    log(LogLevel::Error, error.message);
    emit session.faulted(error);
}

void SessionParts::onOpened(Result<OpenedSource>& result)
{
    if (!result)
        return refuseOpened(result.error());
    const std::string scanner = result->source->description().scanner;
    Result<std::vector<ParametersFrom>> chosen = options.chooseParameters
                                                     ? options.chooseParameters(scanner, result->parameters)
                                                     : defaultParameters(scanner, result->parameters);
    if (!chosen)
        return refuseOpened(chosen.error());
    forget();
    opened = std::move(*result);
    address = openText;
    parameters = std::move(*chosen);
    for (const std::string& warning : opened.warnings)
        log(LogLevel::Warning, warning);
    emit session.parametersChanged();
    emit session.projectChanged();
    const bool isReadOnly = opened.project && !opened.project->readOnlyBecause().empty();
    if (isReadOnly)
        log(LogLevel::Warning, opened.project->readOnlyBecause());
    if (opened.source->isLive()) {
        machine.happen(SessionHappening::Connected);
    } else {
        machine.happen(isReadOnly ? SessionHappening::LoadedReadOnly : SessionHappening::Loaded);
        startScan();
    }
    tellState();
}

void SessionParts::refuseOpened(const Error& error)
{
    happen(SessionHappening::LoadingFailed);
    tellFault(error);
}

/// A recorder for a scan that is taken now, where recording is on.
std::unique_ptr<SliceRecorder> SessionParts::recorder(bool isNextStop)
{
    projectTried_ = false;
    scansBefore_ = 0;
    if (isNextStop) {
        if (const auto file = PwscanProject::open(recordedPath_)) {
            const auto scans = file->scans();
            scansBefore_ = scans ? scans->size() : 0;
        }
        return std::make_unique<PwscanRecorder>(recordedPath_, PwscanRecorder::Target::Append, opened.source->name());
    }
    recordedPath_.clear();
    if (!opened.source->isLive() || options.recordFolder.empty())
        return nullptr;
    recordedPath_ = newRecordingPath(options.recordFolder, QDateTime::currentDateTime());
    if (options.makeRecorder)
        return options.makeRecorder(recordedPath_);
    return std::make_unique<PwscanRecorder>(recordedPath_, PwscanRecorder::Target::NewFile, opened.source->name());
}

std::string SessionParts::noNextStopBecause() const
{
    if (!opened.source || !opened.source->isLive())
        return "A recording is played again and not added to. Connect a scanner for the next stop.";
    std::error_code error;
    if (recordedPath_.empty() || options.makeRecorder || !std::filesystem::exists(recordedPath_, error))
        return "The scan before is not recorded. Turn recording on and take the first stop.";
    return {};
}

Result<void> SessionParts::startAsked(bool isNextStop)
{
    if (Result<void> allowed = request(SessionRequest::Start); !allowed)
        return allowed;
    opened.source->release();
    startScan(isNextStop);
    tellState();
    return {};
}

void SessionParts::startScan(bool isNextStop)
{
    idle.reset();
    run.reset();
    if (opened.source->isLive()) {
        // A scan of its own begins with the parameters that are in force now, and has no file yet.
        parameters = {{0, parameters.back().parameters}};
        opened.project.reset();
        opened.edits.clear();
        emit session.projectChanged();
    }
    auto next = std::make_unique<SessionRun>([this, isNextStop](const ScanEvents& events) {
        auto work = std::make_unique<ScanPipeline>(
            PipelineSetup{opened.source, recorder(isNextStop), parameters, options.explain, true, kRecovery}, events,
            clock);
        pipeline = work.get();
        return work;
    });
    measuredDescription = pipeline->measuredDescription();
    history = ScanHistory{next->work().correctedDescription(), opened.source->plannedSlices().value_or(0)};
    former.clear();
    shownStep = {};
    showMap();
    emit session.historyChanged(0);
    begin(std::move(next));
}

void SessionParts::begin(std::unique_ptr<SessionRun> next)
{
    run = std::move(next);
    connectRun();
    statusTick_.start();
    run->start();
}

void SessionParts::connectRun()
{
    const auto on = [this](auto signal, auto slot) { QObject::connect(run.get(), signal, &session, slot); };
    on(&SessionRun::begun, [this] { happen(SessionHappening::Begun); });
    on(&SessionRun::sourceEnded, [this] { happen(SessionHappening::SourceEnded); });
    on(&SessionRun::sourceFailed, [this](const Error& error) {
        happen(SessionHappening::SourceFailed);
        tellFault(error);
    });
    on(&SessionRun::sourceRecovering, [this](const Error& error, std::chrono::milliseconds wait) {
        log(LogLevel::Warning, error.message + "; it is tried again in " + inSeconds(wait));
    });
    on(&SessionRun::devicesTroubled, [this](const std::vector<FaultRecord>& records) { logRecords(records); });
    on(&SessionRun::recordingTroubled, [this](const Error& error) {
        tellFault(
            {error.code, error.message +
                             ". The scan goes on: its slices are kept in memory, and writing is tried again every "
                             "second"});
    });
    on(&SessionRun::recordingRecovered, [this] { log(LogLevel::Info, "all slices are on the disk again"); });
    on(&SessionRun::recordingClosed, [this] {
        const bool isEmpty = run->work().status().acquired == 0;
        log(LogLevel::Info, recordedPath_ + (isEmpty ? ": no slice has come; nothing is left of it" : ": recorded"));
    });
    on(&SessionRun::recordingGivenUp, [this](const Error& error) { tellFault(error); });
    on(&SessionRun::extractionFailed, [this](const Error& error) { tellFault(error); });
    on(&SessionRun::news, [this] {
        const auto since = clock.now() - shownAt_;
        const auto wait = std::chrono::ceil<std::chrono::milliseconds>(options.frame - since);
        if (!frame_.isActive())
            frame_.start(std::clamp(wait, std::chrono::milliseconds{0}, options.frame));
    });
    on(&SessionRun::ended, [this] { onEnded(); });
}

/// Takes what the run has made; of a rerun it is shown when it is complete.
void SessionParts::takeSteps()
{
    std::vector<ExtractedStep> steps = run->work().take();
    if (steps.empty())
        return;
    if (rerunHistory_) {
        rerunHistory_->add(std::move(steps));
        return;
    }
    history.add(std::move(steps));
    emit session.historyChanged(static_cast<int>(history.steps().size()));
}

void SessionParts::onFrame()
{
    if (!run)
        return;
    shownAt_ = clock.now();
    takeSteps();
    if (!rerunHistory_ && run->work().status().recording.bytes > 0)
        openRecorded();
    if (!rerunHistory_ && std::holds_alternative<std::monostate>(shownStep))
        showMap();
}

void SessionParts::showMap()
{
    if (const int* step = std::get_if<int>(&shownStep))
        map = history.at(*step);
    else if (const std::size_t* place = std::get_if<std::size_t>(&shownStep))
        map = history.after(*place + 1);
    else
        map = history.newest();
    emit session.mapChanged(map);
}

/// All threads have ended: whatever came is worked in, and the recording is closed.
void SessionParts::onEnded()
{
    frame_.stop();
    statusTick_.stop();
    takeSteps();
    lastStatus_ = run->work().status();
    const bool isEmpty = pipeline != nullptr && lastStatus_.acquired == 0;
    // It is emitting this very signal.
    run->setParent(&session);
    run.release()->deleteLater();
    pipeline = nullptr;
    if (rerunHistory_)
        takeRerun();
    if (isEmpty && !recordedPath_.empty())
        opened.project.reset();  // nothing of it is left
    else
        openRecorded();
    showMap();
    happen(isEmpty ? SessionHappening::CaughtUpEmpty : SessionHappening::CaughtUp);
}

/// From now on edits go into the file that the scan is recorded into.
void SessionParts::openRecorded()
{
    if (recordedPath_.empty() || options.makeRecorder || std::exchange(projectTried_, true))
        return;
    Result<PwscanProject> project = PwscanProject::open(recordedPath_);
    if (!project) {
        log(LogLevel::Warning, project.error().message);
        return;
    }
    const auto scans = project->scans();
    if (!scans || scans->size() <= scansBefore_) {
        projectTried_ = false;  // it is not there yet
        return;
    }
    opened.project = std::move(*project);
    opened.scan = scans->back().id;
    emit session.projectBegun();
}

void SessionParts::forget()
{
    frame_.stop();
    statusTick_.stop();
    idle.reset();
    run.reset();
    pipeline = nullptr;
    rerunHistory_.reset();
    lastStatus_ = {};
    opened = {};
    address.clear();
    recordedPath_.clear();
    history = {};
    former.clear();
    shownStep = {};
    showMap();
    emit session.historyChanged(0);
    emit session.projectChanged();
}

void SessionParts::letGo()
{
    if (!machine.isIdle() || machine.goesHome() || !opened.source || opened.source->health().empty())
        return;
    machine.happen(SessionHappening::LetGo);
    idle.reset();
    opened.source.reset();
    if (machine.state() == SessionState::Empty)
        forget();
}

SessionStatus SessionParts::status() const
{
    const PipelineStatus now = run ? run->work().status() : lastStatus_;
    SessionStatus status;
    if (opened.source) {
        status.source = opened.source->name();
        status.plannedSteps = opened.source->plannedSlices().value_or(0);
        if (opened.plan)
            status.plannedTime = opened.plan->time;
    }
    status.slicesPerSecond = run ? now.slicesPerSecond : 0.0;
    status.queueDepth = now.queueDepth;
    status.stepTime = now.stepTime;
    status.acquired = now.acquired;
    status.extracted = now.extracted;
    status.lost = now.lost;
    status.recording = recordedPath_;
    status.recordedBytes = now.recording.bytes;
    status.freeBytes = now.recording.freeBytes;
    status.notOnDisk = now.recording.notOnDisk;
    return status;
}

}  // namespace planewright
