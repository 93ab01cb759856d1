// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <QObject>
#include <QString>

#include "app/session/loops/snapshot_bridge.h"
#include "app/session/session_machine.h"
#include "app/session/session_map.h"
#include "app/session/session_options.h"
#include "core/formats/recording_pwscan.h"
#include "core/pipeline/plane_lives.h"
#include "core/pipeline/step_replay.h"

namespace planewright {

struct SessionParts;

/// A scan from its source to its planes: opens, starts, records, extracts, and keeps every step of it.
///
/// Lives in the GUI's thread, where all its signals come; scanner, recorder, extractor and the reading of files have
/// threads of their own. A verb that is refused gives the reason as a Usage error and changes nothing. What happens to
/// a session, as a scanner that fails, comes as faulted(). Nothing here waits for a scanner or a disk, but close() and
/// the destructor, which stop all motion and then wait for the threads: as long as one call of the recorder takes.
class ScanSession : public QObject {
    Q_OBJECT

public:
    explicit ScanSession(SessionOptions options = {}, QObject* parent = nullptr);
    ~ScanSession() override;

    SessionState state() const;
    /// Why a request would be refused now, for tool tips of what is greyed out; empty where it would not.
    QString refusal(SessionRequest request) const;

    // Verbs.

    /// Opens `sim:SCENE?seed=N&speed=X`, or the address of a laser: Connecting → Ready. `replay:FILE?speed=X`, or a
    /// plain file as fast as possible: Connecting → Replaying → Review. What was open stays until the new one is there;
    /// but for a laser, devices that are open are closed first, and only the scan that was taken with them stays.
    Result<void> open(const std::string& fileOrAddress);
    /// Ends opening, a replay or a rerun.
    Result<void> cancel();
    /// Takes a scan with the scanner that is connected, or plays the recording again.
    Result<void> start();
    /// The same, as one scan more in the file that the last one was recorded into: the next stop of a map.
    Result<void> startNextStop();
    /// Why startNextStop() would be refused now; empty where it would not.
    QString nextStopRefusal() const;
    /// Brings the head of the scanner that is connected to level, slowly, where it is held: Homing, and back. Refused
    /// where nothing moves.
    Result<void> goHome();
    /// Whether goHome() would do something now.
    bool canGoHome() const;
    /// Homing, to level.
    bool goesHome() const;
    Result<void> pauseOrContinue();
    /// One slice more while it is paused.
    Result<void> step();
    /// Ends the scan with what there is: Finishing → Review.
    Result<void> finish();
    /// Tries again what failed. Whoever asks for it has seen to what a device has stopped for.
    Result<void> retry();
    /// Stops whatever moves at once, in every state, and ends the scan with what there is. Nothing moves then before
    /// release(), whatever is opened or closed meanwhile: start(), goHome() and retry() are refused, and whoever moves
    /// devices elsewhere asks isMotionStopped(). Never refused itself; an error is the device's.
    Result<void> stopMotion();
    /// Lets what was stopped move again, when it is asked to.
    Result<void> release();
    bool isMotionStopped() const;
    /// For the steps to come; they are recorded. Of a scan that is over: for the next rerun().
    Result<void> setParameters(const Parameters& parameters);
    /// Extracts the whole scan once more with parameters(); the result takes the place of the present one when it is
    /// complete, and cancel() keeps that. Of a `.pwscan` the parameters are then stored in it.
    Result<void> rerun();
    /// Takes the last rerun() back: the extraction before it is shown again, with its parameters, and of a `.pwscan` it
    /// is what the file gives from now on. redoRerun() makes it again, until the next rerun(). Both cost nothing: all
    /// of it was kept. Refused where rerun() is; without any nothing happens.
    Result<void> undoRerun();
    Result<void> redoRerun();
    /// The last few, as long as the scan is open.
    std::size_t rerunsToUndo() const;
    /// 1 is real time, 0 as fast as possible; also for the next start().
    Result<void> setSpeed(double speed);
    /// Shows the scan as it was after a step (or after the last one before it), while it may go on; goToNewest()
    /// follows it again.
    Result<void> goToStep(int step);
    /// The same by its place in history(): the scan before its forced last pass, too.
    Result<void> goToPlace(int place);
    Result<void> goToNewest();
    /// Stops motion, ends everything and forgets the scan. Never refused.
    void close();

    /// From the next start() on; empty: scans are not recorded.
    void setRecordFolder(const std::string& folder);
    /// What the next `sim:` that is opened is set up with, but for the address's seed and speed.
    void setSimulation(const SimulatedScanner& simulation);
    /// What the next laser that is opened is set up with.
    void setNodding(const NoddingSetup& nodding);

    // What there is.

    /// What mapChanged() gave last; never null.
    std::shared_ptr<const SessionMap> map() const;
    /// Every step of the scan so far in its order, the forced last pass among them.
    const std::vector<ExtractedStep>& history() const;
    /// The scan as it was after a step, or after the last one before it; never null.
    std::shared_ptr<const SessionMap> mapAt(int step) const;
    /// How a step went: what each phase left and every decision with its numbers; kLastPass for the forced last pass,
    /// which is tried out on the slices so far where it has not been made. Scan and history stay as they are. Takes as
    /// long as extracting the steps before it once more, but the step after the one that was asked for last only its
    /// own. Usage error for a step that is not in history().
    Result<std::shared_ptr<const PhasedStep>> explained(int step);
    /// Why two planes are not one, or a segment is not in a plane, after a step: all conditions with their numbers.
    /// Takes as long as explained(). Usage error for what is not there at that step.
    Result<WhyNot> whyNot(int step, const Operand& a, const Operand& b);
    /// Where the planes of history() come from and what became of them, in full with SessionOptions::explain.
    const PlaneLives& planeLives() const;
    SessionStatus status() const;
    /// What the devices of the source say of themselves; nothing of a source that has none.
    std::vector<HealthFact> health() const;
    /// What the devices of the source said of themselves when they were opened; nothing of a source that has none.
    std::optional<KnownScanner> scanner() const;
    /// In force for the next step, and for a rerun.
    const Parameters& parameters() const;
    /// What is said once about the corrected slices; those of map().
    const ScanDescription& description() const;
    /// The slices as they were measured, all of the scan so far, and what is said once about them.
    std::vector<SharedSlice> measuredSlices() const;
    const ScanDescription& measuredDescription() const;
    /// The address or file that is open; empty without one.
    const std::string& address() const;
    /// The `.pwscan` that edits go into: the one that was opened, or that the scan is recorded into, as soon as its
    /// first slice is there. Null without one. Used in the session's thread, until projectChanged().
    PwscanProject* project();
    /// The scan's number in it.
    int scanInProject() const;
    /// What the file that is open lacks; empty where it is sound, or nothing was opened from a file.
    const std::optional<InputDamage>& damage() const;
    /// The edits that were in it when it was opened, undone ones too.
    const std::vector<StoredEdit>& storedEdits() const;
    /// Of a cloud that was imported: what a recording of it is to keep, its name and pose.
    const std::optional<ScanNotes>& imported() const;

signals:
    void stateChanged(planewright::SessionState state);
    /// Motion was stopped, or has been released.
    void motionStoppedChanged(bool isStopped);
    /// There is a newer map, or another step is shown; at most once a frame, and before the state that ends the scan.
    void mapChanged(std::shared_ptr<const planewright::SessionMap> map);
    /// history() has grown to so many steps, or begun anew.
    void historyChanged(int steps);
    void statusChanged(const planewright::SessionStatus& status);
    void parametersChanged();
    /// A rerun() is complete, and is what is shown.
    void rerunMade();
    /// project(), scanInProject() and storedEdits() are others; the project before is gone.
    void projectChanged();
    /// The scan that is open has a project() now: the file that it is recorded into, without edits yet.
    void projectBegun();
    /// Something failed that nobody asked for: what it was, what is safe, what to do.
    void faulted(const planewright::Error& error);
    void logLine(planewright::LogLevel level, const QString& source, const QString& text);

private:
    std::unique_ptr<SessionParts> parts_;
};

}  // namespace planewright
