// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/cli/simulate_options.h"

#include <utility>

#include "app/cli/angle_range.h"
#include "app/cli/recording_file.h"
#include "app/cli/tilt_options.h"
#include "core/formats/recording_csv.h"

namespace planewright {

Result<AcquisitionSettings> settingsOf(const SimulateOptions& options)
{
    AcquisitionSettings settings;  // Table VIII
    if (const auto tilt = takeTilt(options.tilt, options.slices, settings); !tilt)
        return tl::unexpected{tilt.error()};
    if (!options.bearing.empty()) {
        const auto range = parseAngleRange("--bearing", options.bearing, RangeEnd::Closed, kMaxBeams);
        if (!range)
            return tl::unexpected{range.error()};
        if (range->step < 0.0)
            return fail(ErrorCode::Usage, "--bearing: '" + options.bearing + "' goes down; bearings rise from beam 0");
        settings.firstBearing = range->first;
        settings.bearingStep = range->step;
        settings.beams = range->count;
    }
    if (static_cast<std::size_t>(settings.slices) * static_cast<std::size_t>(settings.beams) > kMaxRanges)
        return fail(ErrorCode::Usage, "--tilt, --slices and --bearing give more than " + std::to_string(kMaxRanges) +
                                          " points; give fewer");
    return settings;
}

Result<SimulationNoise> noiseOf(const SimulateOptions& options)
{
    Result<SimulationNoise> noise = simulationNoise(options.noise);
    if (noise && options.dropout >= 0.0)
        noise->dropout = options.dropout / 100.0;
    return noise;
}

SimulatedScan simulatedScan(const Scene& scene, const AcquisitionSettings& settings, const SimulationNoise& noise,
                            std::uint64_t seed, const std::function<void(int slices)>& onSlice)
{
    SimulatedScan scan{{describeScan(settings), {}}, {}};
    for (int step = 0; step < settings.slices; ++step) {
        SimulatedSlice slice = simulateSlice(scene, settings, noise, seed, step);
        scan.recording.slices.push_back(std::move(slice.slice));
        scan.labels.push_back(std::move(slice.labels));
        onSlice(step + 1);
    }
    return scan;
}

}  // namespace planewright
