// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

// What the window says of a scan: the state chip with its facts, and the status bar.

#include <algorithm>
#include <array>

#include <QFileInfo>

#include "app/window/scan_control.h"
#include "ui/models/number_text.h"

namespace planewright {

namespace {

constexpr std::size_t kQueueWarns = 64;

struct Chip {
    const char* text;
    const char* colour;  ///< white on it has a contrast of 4.5 at least
};

/// Sign, words and colour of each state, in the order of the states. What is read-only has a lock before it.
constexpr std::array<Chip, kSessionStates> kChips{{{"○ No scan", "#5f6368"},
                                                   {"◌ Connecting…", "#1f5fae"},
                                                   {"● Ready", "#1f5fae"},
                                                   {"⟳ Moving to start", "#8a5a00"},
                                                   {"● Scanning", "#1b7a36"},
                                                   {"❚❚ Paused", "#8a5a00"},
                                                   {"⟳ Catching up", "#1b7a36"},
                                                   {"✔ Complete", "#1b7a36"},
                                                   {"▶ Replaying", "#6a3fa0"},
                                                   {"▲ Fault", "#b3261e"},
                                                   {"Read-only", "#5f6368"}}};

/// How far a scan is.
QString progress(int steps, int planned)
{
    return QStringLiteral(" %1/%2").arg(steps).arg(planned > 0 ? QString::number(planned) : QStringLiteral("?"));
}

QString words(ReadOnlyCause cause)
{
    switch (cause) {
        case ReadOnlyCause::NewerVersion:
            return ScanControl::tr(": newer version");
        case ReadOnlyCause::HeldElsewhere:
            return ScanControl::tr(": opened elsewhere");
        case ReadOnlyCause::NotWritable:
            return ScanControl::tr(": cannot be written");
        case ReadOnlyCause::None:
            break;
    }
    return {};
}

QString bytes(std::uint64_t count)
{
    if (count < 10'000'000)
        return QStringLiteral("%1 MB").arg(static_cast<double>(count) / 1e6, 0, 'f', 1);
    if (count < 10'000'000'000)
        return QStringLiteral("%1 MB").arg(static_cast<double>(count) / 1e6, 0, 'f', 0);
    return QStringLiteral("%1 GB").arg(static_cast<double>(count) / 1e9, 0, 'f', 0);
}

}  // namespace

void ScanControl::setSeenPhase(const QString& phase)
{
    seenPhase_ = phase;
    refreshOverlay();
}

/// Slices that are worked in; of a scan without gaps the number of its steps so far.
int ScanControl::slicesSoFar() const
{
    const std::vector<ExtractedStep>& steps = parts_.session.history();
    return static_cast<int>(
        std::count_if(steps.begin(), steps.end(), [](const ExtractedStep& step) { return step.slice != nullptr; }));
}

/// The step of the newest slice that is worked in; −1 without one.
int ScanControl::newestStep() const
{
    const std::vector<ExtractedStep>& steps = parts_.session.history();
    const auto newest =
        std::find_if(steps.rbegin(), steps.rend(), [](const ExtractedStep& step) { return step.slice; });
    return newest == steps.rend() ? -1 : (*newest).slice->step;
}

void ScanControl::refreshOverlay()
{
    const SessionState state = parts_.session.state();
    const SessionStatus status = parts_.session.status();
    const ShownMap& map = *parts_.shown;
    const auto& chip = kChips[static_cast<std::size_t>(state)];
    OverlayContent content;
    content.stateColour = QColor(QLatin1String(chip.colour));
    content.stateText = parts_.session.goesHome() ? tr("⟳ Moving to level") : tr(chip.text);
    if (state == SessionState::ReadOnly) {
        content.locked = true;
        if (const PwscanProject* project = parts_.session.project(); project != nullptr)
            content.stateText += words(project->readOnlyCause());
    }
    const int planned = map.plannedSteps;
    const bool looksBack = map.snapshot && !parts_.playhead.followsNewest();
    const int newest = newestStep();
    int last = map.step;
    if (state == SessionState::Scanning || state == SessionState::Replaying || state == SessionState::Paused) {
        last = looksBack ? newest : map.step;
        content.stateText += progress(last + 1, planned);
    }
    if ((state == SessionState::Review || state == SessionState::ReadOnly) && map.snapshot) {
        last = newest >= 0 ? newest : map.step;
        const int slices = slicesSoFar();
        const bool whole = planned > 0 && slices >= planned && status.lost == 0 && !parts_.session.damage();
        if (state == SessionState::Review)
            content.stateText = whole ? tr("✔ Complete") : tr("◐ Partial");
        else if (!whole)
            content.stateText += tr(", partial");
        if (state == SessionState::Review && !whole)
            content.stateColour = QColor(QStringLiteral("#8a5a00"));
        content.stateText += progress(slices, planned);
        content.stateText +=
            QStringLiteral(", ") + countText(static_cast<qsizetype>(map.planes.size()), tr("plane"), tr("planes"));
    }
    if (parts_.session.isMotionStopped()) {
        content.stateText += tr(", motion stopped");
        content.stateColour = QColor(QStringLiteral("#b3261e"));
    }
    if (map.step < last || (looksBack && !map.finished) || !seenPhase_.isEmpty()) {
        content.stateText += tr("\nseen at step %1").arg(map.step + 1);
        if (!seenPhase_.isEmpty())
            content.stateText += tr(" after %1").arg(seenPhase_);
    }
    if (map.snapshot) {
        qulonglong returns = 0;
        for (const ExtractedStep& step : parts_.session.history()) {
            const StepReport& report = step.snapshot->report;
            returns += report.step >= 0 && report.step <= map.step ? static_cast<qulonglong>(report.counts.returns) : 0;
        }
        const QLocale grouped(QLocale::English);
        content.facts = {
            tr("returns %1").arg(grouped.toString(returns)),
            tr("segments %1").arg(grouped.toString(static_cast<qulonglong>(map.snapshot->segments.segmentCount()))),
            tr("planes %1").arg(static_cast<int>(map.planes.size()))};
    }
    if (state == SessionState::Ready && !map.snapshot && parts_.session.isMotionStopped()) {
        content.hint = tr("Release the motion, then press F5 to scan.");
    } else if (state == SessionState::Ready && !map.snapshot) {
        constexpr double kTurnOfTheMirror = 0.025;  // [s]
        const double seconds =
            status.plannedTime.count() > 0.0 ? status.plannedTime.count() : status.plannedSteps * kTurnOfTheMirror;
        content.hint = tr("Press F5 to scan %1 steps, about %2 s.").arg(status.plannedSteps).arg(seconds, 0, 'f', 1);
    }
    parts_.window->view().setOverlay(content);
}

void ScanControl::takeStatus(const SessionStatus& status)
{
    MainWindow& window = *parts_.window;
    window.setStatus(
        QStringLiteral("stDevice"),
        status.source.empty()
            ? tr("no source")
            : tr("● %1  %2/s").arg(QString::fromStdString(status.source)).arg(status.slicesPerSecond, 0, 'f', 1),
        tr("Source and its slices per second"));
    window.setStatus(QStringLiteral("stLoss"), tr("lost %1").arg(status.lost), tr("Steps that were passed over"),
                     status.lost > 0);
    window.setStatus(QStringLiteral("stQueue"), tr("queue %1").arg(status.queueDepth),
                     tr("Slices that wait to be recorded or extracted"), status.queueDepth >= kQueueWarns);
    const double milliseconds = static_cast<double>(status.stepTime.count()) / 1e6;
    window.setStatus(QStringLiteral("stStep"), tr("step %1 ms of 25").arg(milliseconds, 0, 'f', 2),
                     tr("Time of the last step, and what there is between two slices"), milliseconds > 25.0);
    QString recording = status.recording.empty() ? tr("not recorded") : tr("rec %1").arg(bytes(status.recordedBytes));
    if (!status.recording.empty() && status.freeBytes)
        recording += tr(", %1 free").arg(bytes(*status.freeBytes));
    if (status.notOnDisk > 0)
        recording +=
            tr(", %1 not on disk").arg(countText(static_cast<qsizetype>(status.notOnDisk), tr("slice"), tr("slices")));
    window.setStatus(QStringLiteral("stRec"), recording, QString::fromStdString(status.recording),
                     status.notOnDisk > 0);
    refreshActions();
    // The map stays while somebody looks back, and how far the scan is does not.
    if (!parts_.playhead.followsNewest())
        refreshOverlay();
}

}  // namespace planewright
