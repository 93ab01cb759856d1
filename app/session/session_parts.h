// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <QTimer>

#include "app/session/former_extractions.h"
#include "app/session/idle_run.h"
#include "app/session/scan_history.h"
#include "app/session/scan_session.h"
#include "app/session/session_run.h"
#include "app/session/source_opener.h"

namespace planewright {

/// What a session is made of, and what follows when one of its parts has news.
struct SessionParts {
    SessionParts(ScanSession& owner, SessionOptions chosen);

    // Verbs come here when they are allowed.
    Result<void> request(SessionRequest request);
    void happen(SessionHappening happening);
    /// Of a next stop the scan is one more in the file of the one before.
    void startScan(bool isNextStop = false);
    /// Starts it where that is allowed now.
    Result<void> startAsked(bool isNextStop);
    void startRerun();
    void cancelRerun();
    /// Shows another of the kept extractions.
    Result<void> exchange(bool (FormerExtractions::*verb)(ScanHistory&));
    void forget();
    /// Closes devices between scans, if some are open; what was scanned with them stays.
    void letGo();

    // What the outside is told.
    void tellState();
    void showMap();
    /// Why the scan before has no file that one more could be recorded into; empty where it has.
    std::string noNextStopBecause() const;
    void log(LogLevel level, const std::string& text);
    void logRecords(const std::vector<FaultRecord>& records);
    SessionStatus status() const;

    ScanSession& session;
    SessionOptions options;
    const Clock& clock;
    SessionMachine machine;
    SourceOpener opener;
    std::string openText;  ///< what is being opened
    std::string address;   ///< what is open
    OpenedSource opened;
    std::vector<ParametersFrom> parameters;  ///< of the next scan or replay; the last are those in force
    ScanDescription measuredDescription;     ///< of the slices as they were measured
    ScanHistory history;
    FormerExtractions former;  ///< what reruns took the place of
    /// What somebody has gone back to: a step, or a place in the history.
    std::variant<std::monostate, int, std::size_t> shownStep;
    std::shared_ptr<const SessionMap> map;

    std::unique_ptr<IdleRun> idle;     ///< while a scanner with devices is there and no scan runs
    std::unique_ptr<SessionRun> run;   ///< while slices are taken or worked in
    ScanPipeline* pipeline = nullptr;  ///< its work, unless it is a rerun

private:
    void onOpened(Result<OpenedSource>& result);
    void refuseOpened(const Error& error);
    void begin(std::unique_ptr<SessionRun> next);
    void connectRun();
    void onFrame();
    void onEnded();
    void takeSteps();
    void takeRerun();
    void storeParameters();
    void openRecorded();
    std::unique_ptr<SliceRecorder> recorder(bool isNextStop);
    void minds();
    void tellFault(const Error& error);

    std::optional<ScanHistory> rerunHistory_;  ///< of a rerun, until it is complete
    bool rerunCancelled_ = false;
    std::size_t scansBefore_ = 0;  ///< of the file that is recorded into
    bool projectTried_ = false;    ///< the file that is recorded into has been opened for edits, or cannot be
    std::string recordedPath_;     ///< of the scan that is taken; empty: it is not recorded
    SessionState told_ = SessionState::Empty;
    bool toldStopped_ = false;
    PipelineStatus lastStatus_;  ///< of the run before
    std::chrono::nanoseconds shownAt_{0};
    QTimer frame_;
    QTimer statusTick_;
};

}  // namespace planewright
