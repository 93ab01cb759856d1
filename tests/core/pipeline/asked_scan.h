// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <memory>
#include <string_view>

#include <QtTest>

#include "core/params/presets.h"
#include "core/pipeline/step_replay.h"
#include "tests/core/pipeline/simulated_room.h"

namespace planewright {

/// A simulated scan that can be asked about its steps.
struct AskedScan {
    SimulatedRoom room;
    StepReplay replay;

    AskedScan(const QString& preset, std::string_view scene)
        : room(scanOf(scene, "default", 3, "table10-2")),
          replay(sensorOf(room.scan.recording.description), parametersOf(preset))
    {
        for (const ScanSlice& slice : room.scan.recording.slices)
            replay.add(std::make_shared<const ScanSlice>(slice));
    }

    static Parameters parametersOf(const QString& preset)
    {
        Parameters parameters;
        apply(*findPreset(methodPresets(), preset.toStdString()), parameters);
        return parameters;
    }

    int steps() const { return static_cast<int>(room.scan.recording.slices.size()); }
};

/// What is asked about: segments of the newest slices and of the middle of planes.
inline std::vector<SegmentId> askedSegments(const Snapshot& snapshot)
{
    std::vector<SegmentId> asked;
    const std::size_t slices = snapshot.segments.slices();
    for (std::size_t place = slices < 2 ? 0 : slices - 2; place < slices; ++place) {
        for (const LineSegment& segment : snapshot.segments.slice(place))
            asked.push_back(segment.id);
    }
    for (const auto& plane : snapshot.planes)
        asked.push_back(plane->segments[plane->segments.size() / 2]);
    return asked;
}

inline const Conditions& wayOf(const WhyNot& answer, std::string_view name)
{
    const auto found =
        std::find_if(answer.ways.begin(), answer.ways.end(), [&](const Conditions& w) { return w.name == name; });
    if (found == answer.ways.end())
        qFatal("there is no such way");
    return *found;
}

}  // namespace planewright
