// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>

#include <QObject>

#include "app/window/window_parts.h"

namespace planewright {

/// Runs the session from the window: actions of the scan, state chip, status bar, banners.
class ScanControl : public QObject {
    Q_OBJECT

public:
    explicit ScanControl(WindowParts& parts);

    /// Opens a file or an address; a room is simulated as `sim:` does by itself. With `starts` a simulated scan begins
    /// as soon as it is ready.
    void open(const QString& fileOrAddress, bool starts = false);

    /// Scans a room that is set up.
    void simulate(const SimulationSetup& setup);
    /// Scans the room of an address with this scanner.
    void openRoom(const SimulatedScanner& simulation, const QString& address) { openWith(simulation, address, true); }

    /// The set-up of the room that was opened last, where an address does not say all of it.
    const std::optional<SimulationSetup>& simulated() const { return simulated_; }

    /// Names the phase of a step that is looked at; empty for none.
    void setSeenPhase(const QString& phase);
    /// Motion is stopped: says so, with what releases it, and gives false.
    bool mayMove();

private:
    void openWith(const SimulatedScanner& simulation, const QString& fileOrAddress, bool starts);
    void start();
    void startNextStop();
    bool hasRoomIn(const QString& folder);
    void prepareRecording();
    void connectActions();
    void connectSession();
    void act(const Result<void>& result);
    void showFault(const QString& text);
    void showMotionStopped(bool isStopped);
    void showFlawsOfFile();
    void takeState(SessionState state);
    void takeStatus(const SessionStatus& status);
    void refreshActions();
    int newestStep() const;
    int slicesSoFar() const;
    void refreshOverlay();
    void addRecent(const QString& file);
    void showRecent();

    WindowParts& parts_;
    bool startsWhenReady_ = false;
    std::optional<SimulationSetup> simulated_;
    QString seenPhase_;
    std::shared_ptr<const Parameters> tableParameters_;  ///< that the table of planes tells of
};

}  // namespace planewright
