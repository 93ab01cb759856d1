// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/segments/noise_doubt.h"

#include <cmath>
#include <cstdint>

#include "core/geometry/sensor_model.h"
#include "core/segments/range_noise.h"

namespace planewright {

namespace {

/// Ranges that scatter by more than so many times what is told are in doubt.
constexpr double kFarTooMuch = 2.0;
/// Fewer samples tell too little.
constexpr std::int64_t kTellingSamples = 500;

double meanRange(const Recording& recording, const SensorModel& sensor)
{
    double sum = 0.0;
    std::int64_t echoes = 0;
    for (const ScanSlice& slice : recording.slices) {
        for (const double range : slice.ranges) {
            if (!sensor.hasEcho(range))
                continue;
            sum += range;
            ++echoes;
        }
    }
    return echoes > 0 ? sum / static_cast<double>(echoes) : 0.0;
}

}  // namespace

std::optional<NoiseDoubt> noiseDoubtOf(const Recording& recording, const NoiseParameters& told)
{
    if (told.estimated)
        return std::nullopt;
    const SensorModel sensor = sensorOf(recording.description);
    RangeNoise noise;
    for (const ScanSlice& slice : recording.slices)
        noise.add(slice, sensor, told);
    if (noise.samples() < kTellingSamples)
        return std::nullopt;
    const double range = meanRange(recording, sensor);
    const NoiseDoubt doubt{range, std::sqrt(noise.estimate(told).rangeVariance(range)),
                           std::sqrt(told.rangeVariance(range))};
    return doubt.found > kFarTooMuch * doubt.told ? std::optional{doubt} : std::nullopt;
}

}  // namespace planewright
