// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/emulated/emulated_view.h"

#include <cmath>
#include <utility>

#include "core/simulation/nodding_scanner.h"

namespace planewright {

EmulatedView::EmulatedView(Scene scene, const SimulationNoise& noise, std::uint64_t seed, double pitchAxisOffset)
    : scene_(std::move(scene)), noise_(noise), seed_(seed), pitchAxisOffset_(pitchAxisOffset)
{
}

std::vector<std::uint32_t> EmulatedView::ranges(const Sweep& sweep, int number) const
{
    AcquisitionSettings settings;
    settings.tiltStep = sweep.lastPitch - sweep.firstPitch;
    settings.continuous = settings.tiltStep != 0.0;
    settings.firstTilt = sweep.firstPitch - number * settings.tiltStep;  // the slice of this number is at firstPitch
    settings.slices = number + 1;
    settings.firstBearing = sweep.firstBearing;
    settings.bearingStep = sweep.bearingStep;
    settings.beams = sweep.beams;
    settings.rangeMin = sweep.rangeMin;
    settings.rangeMax = sweep.rangeMax;
    settings.pitchAxisOffset = pitchAxisOffset_;

    const SimulatedSlice slice = simulateSlice(scene_, settings, noise_, seed_, number);
    std::vector<std::uint32_t> ranges;
    ranges.reserve(slice.slice.ranges.size());
    for (const double range : slice.slice.ranges)
        ranges.push_back(static_cast<std::uint32_t>(std::lround(1000.0 * range)));
    return ranges;
}

}  // namespace planewright
