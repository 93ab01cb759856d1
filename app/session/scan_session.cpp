// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/session/scan_session.h"

#include <algorithm>

#include <QThread>

#include "app/session/session_parts.h"

namespace planewright {

ScanSession::ScanSession(SessionOptions options, QObject* parent)
    : QObject(parent), parts_(std::make_unique<SessionParts>(*this, std::move(options)))
{
}

ScanSession::~ScanSession()
{
    // Whoever listens may be half gone already.
    blockSignals(true);
    close();
}

SessionState ScanSession::state() const
{
    return parts_->machine.state();
}

QString ScanSession::refusal(SessionRequest request) const
{
    const std::string_view why = parts_->machine.refusal(request);
    return QString::fromUtf8(why.data(), static_cast<qsizetype>(why.size()));
}

Result<void> ScanSession::open(const std::string& fileOrAddress)
{
    const Result<SourceAddress> address = parseSourceAddress(fileOrAddress);
    if (!address)
        return tl::unexpected{address.error()};
    // Devices serve one program at a time, and those that are open may be the ones that are named.
    if (address->kind == SourceAddress::Kind::Laser && refusal(SessionRequest::Open).isEmpty())
        parts_->letGo();
    if (Result<void> allowed = parts_->request(SessionRequest::Open); !allowed)
        return allowed;
    parts_->openText = fileOrAddress;
    parts_->opener.open(*address, {parts_->options.simulation, parts_->options.nodding});
    parts_->tellState();
    return {};
}

Result<void> ScanSession::cancel()
{
    const bool isOpening = state() == SessionState::Connecting;
    if (Result<void> allowed = parts_->request(SessionRequest::Cancel); !allowed)
        return allowed;
    if (isOpening)
        parts_->opener.cancel();
    else if (parts_->pipeline != nullptr)
        parts_->pipeline->finish();
    else
        parts_->cancelRerun();
    parts_->tellState();
    return {};
}

Result<void> ScanSession::start()
{
    return parts_->startAsked(false);
}

QString ScanSession::nextStopRefusal() const
{
    const QString refused = refusal(SessionRequest::Start);
    return refused.isEmpty() ? QString::fromStdString(parts_->noNextStopBecause()) : refused;
}

Result<void> ScanSession::startNextStop()
{
    if (const QString refused = nextStopRefusal(); !refused.isEmpty())
        return fail(ErrorCode::Usage, refused.toStdString());
    return parts_->startAsked(true);
}

Result<void> ScanSession::goHome()
{
    if (Result<void> allowed = parts_->request(SessionRequest::GoHome); !allowed)
        return allowed;
    if (!parts_->idle) {
        parts_->happen(SessionHappening::Home);
        return fail(ErrorCode::Usage, "A simulated scanner has no head that moves.");
    }
    parts_->opened.source->release();
    parts_->idle->goHome();
    parts_->tellState();
    return {};
}

bool ScanSession::canGoHome() const
{
    return parts_->idle && parts_->machine.refusal(SessionRequest::GoHome).empty();
}

bool ScanSession::goesHome() const
{
    return parts_->machine.goesHome();
}

Result<void> ScanSession::pauseOrContinue()
{
    const bool pauses = state() != SessionState::Paused;
    if (const std::string_view why = parts_->machine.refusal(pauses ? SessionRequest::Pause : SessionRequest::Continue);
        !why.empty())
        return fail(ErrorCode::Usage, std::string{why});
    if (Result<void> done = pauses ? parts_->pipeline->pause() : parts_->pipeline->resume(); !done)
        return done;
    Result<void> done = parts_->request(pauses ? SessionRequest::Pause : SessionRequest::Continue);
    parts_->tellState();
    return done;
}

Result<void> ScanSession::step()
{
    if (Result<void> allowed = parts_->request(SessionRequest::Step); !allowed)
        return allowed;
    return parts_->pipeline->step();
}

Result<void> ScanSession::finish()
{
    if (Result<void> allowed = parts_->request(SessionRequest::Finish); !allowed)
        return allowed;
    if (parts_->pipeline != nullptr)
        parts_->pipeline->finish();
    parts_->tellState();
    return {};
}

Result<void> ScanSession::retry()
{
    if (Result<void> allowed = parts_->request(SessionRequest::Retry); !allowed)
        return allowed;
    if (parts_->opened.source)
        parts_->opened.source->release();
    if (parts_->pipeline != nullptr)
        parts_->pipeline->retry();
    parts_->tellState();
    return {};
}

Result<void> ScanSession::stopMotion()
{
    // The device first: nothing stands between the button and what moves.
    Result<void> stopped;
    if (parts_->opened.source)
        stopped = parts_->opened.source->stopMotion();
    const bool isOpening = state() == SessionState::Connecting;
    [[maybe_unused]] const Result<void> allowed = parts_->request(SessionRequest::StopMotion);
    if (isOpening)
        parts_->opener.cancel();
    if (state() == SessionState::Finishing && parts_->pipeline != nullptr)
        parts_->pipeline->finish();
    parts_->tellState();
    return stopped;
}

Result<void> ScanSession::release()
{
    if (Result<void> allowed = parts_->request(SessionRequest::Release); !allowed)
        return allowed;
    if (parts_->opened.source)
        parts_->opened.source->release();
    parts_->tellState();
    return {};
}

bool ScanSession::isMotionStopped() const
{
    return parts_->machine.isMotionStopped();
}

Result<void> ScanSession::setParameters(const Parameters& parameters)
{
    if (Result<void> allowed = parts_->request(SessionRequest::SetParameters); !allowed)
        return allowed;
    parts_->parameters = {{0, parameters}};
    if (parts_->pipeline != nullptr)
        parts_->pipeline->setParameters(parameters);
    emit parametersChanged();
    return {};
}

Result<void> ScanSession::rerun()
{
    if (Result<void> allowed = parts_->request(SessionRequest::Rerun); !allowed)
        return allowed;
    parts_->startRerun();
    parts_->tellState();
    return {};
}

Result<void> ScanSession::undoRerun()
{
    return parts_->exchange(&FormerExtractions::takeBack);
}

Result<void> ScanSession::redoRerun()
{
    return parts_->exchange(&FormerExtractions::makeAgain);
}

std::size_t ScanSession::rerunsToUndo() const
{
    return parts_->former.size();
}

Result<void> ScanSession::setSpeed(double speed)
{
    if (Result<void> allowed = parts_->request(SessionRequest::SetSpeed); !allowed)
        return allowed;
    return parts_->opened.source->setSpeed(speed);
}

Result<void> ScanSession::goToStep(int step)
{
    if (Result<void> allowed = parts_->request(SessionRequest::GoToStep); !allowed)
        return allowed;
    parts_->shownStep = step;
    parts_->showMap();
    return {};
}

Result<void> ScanSession::goToPlace(int place)
{
    if (Result<void> allowed = parts_->request(SessionRequest::GoToStep); !allowed)
        return allowed;
    parts_->shownStep = static_cast<std::size_t>(std::max(place, 0));
    parts_->showMap();
    return {};
}

Result<void> ScanSession::goToNewest()
{
    if (Result<void> allowed = parts_->request(SessionRequest::GoToStep); !allowed)
        return allowed;
    parts_->shownStep = {};
    parts_->showMap();
    return {};
}

void ScanSession::close()
{
    if (parts_->opened.source)
        static_cast<void>(parts_->opened.source->stopMotion());
    parts_->opener.cancel();
    parts_->forget();
    [[maybe_unused]] const Result<void> closed = parts_->request(SessionRequest::Close);
    parts_->tellState();
}

void ScanSession::setRecordFolder(const std::string& folder)
{
    parts_->options.recordFolder = folder;
}

void ScanSession::setSimulation(const SimulatedScanner& simulation)
{
    parts_->options.simulation = simulation;
}

void ScanSession::setNodding(const NoddingSetup& nodding)
{
    parts_->options.nodding = nodding;
}

std::vector<SharedSlice> ScanSession::measuredSlices() const
{
    return parts_->history.measured();
}

const ScanDescription& ScanSession::measuredDescription() const
{
    return parts_->measuredDescription;
}

std::shared_ptr<const SessionMap> ScanSession::map() const
{
    return parts_->map;
}

const std::vector<ExtractedStep>& ScanSession::history() const
{
    return parts_->history.steps();
}

std::shared_ptr<const SessionMap> ScanSession::mapAt(int step) const
{
    return parts_->history.at(step);
}

Result<std::shared_ptr<const PhasedStep>> ScanSession::explained(int step)
{
    return parts_->history.explained(step);
}

Result<WhyNot> ScanSession::whyNot(int step, const Operand& a, const Operand& b)
{
    return parts_->history.whyNot(step, a, b);
}

const PlaneLives& ScanSession::planeLives() const
{
    return parts_->history.lives();
}

SessionStatus ScanSession::status() const
{
    return parts_->status();
}

std::vector<HealthFact> ScanSession::health() const
{
    return parts_->opened.source ? parts_->opened.source->health() : std::vector<HealthFact>{};
}

std::optional<KnownScanner> ScanSession::scanner() const
{
    return parts_->opened.scanner;
}

const Parameters& ScanSession::parameters() const
{
    return parts_->parameters.back().parameters;
}

const ScanDescription& ScanSession::description() const
{
    return parts_->history.description();
}

const std::string& ScanSession::address() const
{
    return parts_->address;
}

PwscanProject* ScanSession::project()
{
    return parts_->opened.project ? &*parts_->opened.project : nullptr;
}

int ScanSession::scanInProject() const
{
    return parts_->opened.scan;
}

const std::optional<InputDamage>& ScanSession::damage() const
{
    return parts_->opened.damage;
}

const std::vector<StoredEdit>& ScanSession::storedEdits() const
{
    return parts_->opened.edits;
}

const std::optional<ScanNotes>& ScanSession::imported() const
{
    return parts_->opened.imported;
}

}  // namespace planewright
