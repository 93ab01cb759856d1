// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/geometry/correct_recording.h"

#include <algorithm>
#include <cstddef>

#include "core/geometry/sensor_model.h"

namespace planewright {

namespace {

void correctRanges(Recording& recording, double offset)
{
    const SensorModel measured = sensorOf(recording.description);
    for (ScanSlice& slice : recording.slices) {
        for (double& range : slice.ranges)
            range = measured.hasEcho(range) ? std::max(0.0, range + offset) : 0.0;
    }
    recording.description.rangeMin = std::max(0.0, recording.description.rangeMin + offset);
    recording.description.rangeMax = std::max(0.0, recording.description.rangeMax + offset);
}

void correctPitches(std::vector<ScanSlice>& slices, const SensorParameters& sensor)
{
    const std::vector<double> rates = noddingRates(slices);
    for (std::size_t i = 0; i < slices.size(); ++i) {
        ScanSlice& slice = slices[i];
        const double end = slice.tiltEnd.value_or(slice.tilt);
        const double shift = sensor.pitchZero + sensor.pitchDelay * rates[i];
        slice.tilt += shift;
        if (slice.tiltEnd || sensor.sweepTurn != 0.0)
            slice.tiltEnd = end + shift + sensor.sweepTurn * rates[i];
    }
}

}  // namespace

void correctRecording(Recording& recording, const SensorParameters& sensor)
{
    recording.description.pitchAxisOffset += sensor.leverArmCorrection;
    if (sensor.rangeOffset != 0.0)
        correctRanges(recording, sensor.rangeOffset);
    if (sensor.pitchZero != 0.0 || sensor.pitchDelay != 0.0 || sensor.sweepTurn != 0.0)
        correctPitches(recording.slices, sensor);
}

std::vector<double> noddingRates(const std::vector<ScanSlice>& slices)
{
    std::vector<double> rates(slices.size(), 0.0);
    for (std::size_t i = 0; i < slices.size(); ++i) {
        const ScanSlice& before = slices[i == 0 ? 0 : i - 1];
        const ScanSlice& after = slices[std::min(i + 1, slices.size() - 1)];
        if (after.step > before.step)
            rates[i] = (after.tilt - before.tilt) / (after.step - before.step);
    }
    return rates;
}

}  // namespace planewright
