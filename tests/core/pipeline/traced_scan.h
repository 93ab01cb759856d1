// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include "core/segments/slice_trace.h"
#include "tests/core/pipeline/told_step.h"

namespace planewright {

/// The beams of a slice that met something.
inline std::vector<int> beamsWithEcho(const ScanSlice& slice, const SensorModel& sensor)
{
    std::vector<int> beams;
    for (int beam = 0; beam < static_cast<int>(slice.ranges.size()); ++beam) {
        if (sensor.hasEcho(slice.ranges[static_cast<std::size_t>(beam)]))
            beams.push_back(beam);
    }
    return beams;
}

/// Traces of all slices of a scan, as the window shows them.
struct TracedScan {
    ToldScan scan;
    SensorModel sensor;
    bool isPrecise;

    TracedScan(const QString& preset, const QString& scene)
        : scan(preset.toStdString(), scene.toStdString(), 3),
          sensor(sensorOf(scan.recording.description)),
          isPrecise(preset == "precise")
    {
    }

    template <class Visit>
    void visit(Visit visit) const
    {
        for (const ToldPhase& phase : scan.phases) {
            if (phase.phase != Phase::Extract)
                continue;
            const Parameters parameters = withNoise(scan.parameters, phase.after->noise);
            const ScanSlice& slice = scan.sliceOf(phase.step);
            visit(phase, slice, parameters, traceSlice(slice, sensor, parameters));
        }
    }
};

}  // namespace planewright
