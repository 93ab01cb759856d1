// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <QtTest>

#include "core/params/presets.h"
#include "core/pipeline/step_replay.h"
#include "tests/core/pipeline/simulated_room.h"
#include "tests/core/planes/recorded_decisions.h"

namespace planewright {

/// A phase with what was there before it, as somebody sees it who knows no more than snapshots and decisions.
struct ToldPhase {
    Phase phase = Phase::Extract;
    std::string_view pass;
    int step = 0;
    std::shared_ptr<const Snapshot> before;
    std::shared_ptr<const Snapshot> after;

    const std::vector<Decision>& decisions() const { return after->report.decisions; }
    std::string text() const
    {
        return "step " + std::to_string(step) + ", " + std::string{name(phase)} + " " + std::string{pass};
    }
};

inline const Plane* planeIn(const Snapshot& snapshot, PlaneId id)
{
    const auto found = std::find_if(snapshot.planes.begin(), snapshot.planes.end(),
                                    [id](const auto& plane) { return plane->id == id; });
    return found == snapshot.planes.end() ? nullptr : found->get();
}

inline const DirectionCluster* clusterIn(const Snapshot& snapshot, ClusterId id)
{
    const auto found = std::find_if(snapshot.clusters.begin(), snapshot.clusters.end(),
                                    [id](const auto& cluster) { return cluster->id == id; });
    return found == snapshot.clusters.end() ? nullptr : found->get();
}

inline bool holds(const std::vector<SegmentId>& segments, const SegmentId& segment)
{
    return std::find(segments.begin(), segments.end(), segment) != segments.end();
}

/// The plane that a segment belongs to; null for none.
inline const Plane* ownerOf(const SegmentId& segment, const Snapshot& snapshot)
{
    const auto owner = std::find_if(snapshot.planes.begin(), snapshot.planes.end(),
                                    [&](const auto& plane) { return holds(plane->segments, segment); });
    return owner == snapshot.planes.end() ? nullptr : owner->get();
}

/// A simulated scan, gone through phase by phase.
struct ToldScan {
    Recording recording;
    Parameters parameters;
    std::vector<ToldPhase> phases;

    const ScanSlice& sliceOf(int step) const
    {
        return *std::find_if(recording.slices.begin(), recording.slices.end(),
                             [step](const ScanSlice& slice) { return slice.step == step; });
    }

    ToldScan(std::string_view preset, std::string_view scene, std::uint64_t seed)
        : recording(scanOf(scene, "default", seed, "table10-2").scan.recording)
    {
        apply(*findPreset(methodPresets(), preset), parameters);
        StepReplay replay(sensorOf(recording.description), parameters);
        for (const ScanSlice& slice : recording.slices)
            replay.add(std::make_shared<const ScanSlice>(slice));
        auto before = std::make_shared<const Snapshot>();
        for (std::size_t i = 0; i <= recording.slices.size(); ++i) {
            const int step = i < recording.slices.size() ? recording.slices[i].step : kLastPass;
            const auto went = *replay.at(step);
            for (const PhaseState& state : went->phases) {
                phases.push_back({state.phase, state.pass, step, before, state.snapshot});
                before = state.snapshot;
            }
        }
    }
};

/// Echoes of a slice from one beam to another.
inline int echoesIn(const ScanSlice& slice, const SensorModel& sensor, int firstBeam, int lastBeam)
{
    int echoes = 0;
    for (int beam = firstBeam; beam <= lastBeam; ++beam)
        echoes += sensor.hasEcho(slice.ranges[static_cast<std::size_t>(beam)]) ? 1 : 0;
    return echoes;
}

/// How many numbers of each name were worked out anew.
struct Recomputed {
    std::map<std::string_view, int> counts;

    /// False, with a message, where a told number is another.
    bool agree(const ToldPhase& phase, std::string_view name, double told, double expected, double relative = 1e-9)
    {
        ++counts[name];
        const bool same = std::abs(told - expected) <= relative * std::max({1e-9, std::abs(told), std::abs(expected)});
        if (!same)
            qWarning("%s: %s is told as %.12g and is %.12g", phase.text().c_str(), std::string{name}.c_str(), told,
                     expected);
        return same;
    }
    bool agree(const ToldPhase& phase, const Test& told, double value, double limit, double relative = 1e-9)
    {
        return agree(phase, told.name, told.value, value, relative) &&
               agree(phase, told.name, told.limit, limit, relative);
    }
};

}  // namespace planewright
