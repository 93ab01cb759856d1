// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/models/inspected_step.h"

#include <algorithm>
#include <array>

namespace planewright {

namespace {

/// The decisions of a phase: they stand together in a report.
std::span<const Decision> decisionsOf(Phase phase, const std::vector<Decision>& all)
{
    const auto isOf = [phase](const Decision& decision) { return decision.phase == phase; };
    const auto first = std::find_if(all.begin(), all.end(), isOf);
    return {first, std::find_if_not(first, all.end(), isOf)};
}

/// After how many steps a phase is due again and again.
int everyOf(Phase phase, const ScheduleParameters& schedule)
{
    switch (phase) {
        case Phase::Fit:
            return schedule.fitEvery;
        case Phase::SplitMerge:
            return schedule.splitAndMergeEvery;
        case Phase::Remaining:
            return schedule.remainingEvery;
        case Phase::Extract:
        case Phase::Assign:
        case Phase::Cluster:
        case Phase::Finish:
            break;
    }
    return 1;
}

}  // namespace

std::vector<InspectedPhase> phasesOf(const InspectedStep& step)
{
    std::vector<InspectedPhase> phases;
    const StepReport& report = step.snapshot->report;
    if (report.step < 0) {
        if (!step.phased) {
            phases.push_back({Phase::Finish, {}, 0, step.snapshot, report.decisions, {}, {}});
            return phases;
        }
        for (std::size_t i = 0; i < step.phased->phases.size(); ++i) {
            const PhaseState& pass = step.phased->phases[i];
            phases.push_back({pass.phase, pass.pass, i, pass.snapshot, pass.snapshot->report.decisions, {}, {}});
        }
        return phases;
    }
    std::size_t number = 0;
    for (const Phase phase :
         {Phase::Extract, Phase::Assign, Phase::Cluster, Phase::Fit, Phase::SplitMerge, Phase::Remaining}) {
        const int every = everyOf(phase, step.parameters.schedule);
        InspectedPhase row;
        row.phase = phase;
        row.time = report.times[static_cast<std::size_t>(phase)];
        if ((report.step + 1) % every != 0) {
            row.next = ((report.step + 1) / every + 1) * every - 1;
        } else {
            row.number = number++;
            row.after = step.phased && *row.number < step.phased->phases.size()
                            ? step.phased->phases[*row.number].snapshot
                            : step.snapshot;
            row.decisions = decisionsOf(phase, row.after->report.decisions);
        }
        phases.push_back(std::move(row));
    }
    return phases;
}

std::vector<SegmentId> segmentsOfCluster(ClusterId cluster, const Snapshot* before, const Snapshot& after)
{
    std::vector<SegmentId> segments;
    for (const Snapshot* snapshot : {before, &after}) {
        if (snapshot == nullptr)
            continue;
        for (const auto& candidate : snapshot->clusters) {
            if (candidate->id == cluster)
                segments.insert(segments.end(), candidate->segments.begin(), candidate->segments.end());
        }
    }
    for (const Decision& decision : after.report.decisions) {
        if (decision.kind != DecisionKind::Cluster || decision.result.empty() || decision.operands.empty())
            continue;
        const auto* joined = std::get_if<ClusterRef>(&decision.result.front());
        const auto* segment = std::get_if<SegmentId>(&decision.operands.front());
        if (joined != nullptr && joined->id == cluster && segment != nullptr)
            segments.push_back(*segment);
    }
    std::sort(segments.begin(), segments.end());
    segments.erase(std::unique(segments.begin(), segments.end()), segments.end());
    return segments;
}

}  // namespace planewright
