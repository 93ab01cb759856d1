// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/geometry/correct_recording.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "core/geometry/slice_corrector.h"

namespace planewright {

void correctRecording(Recording& recording, const SensorParameters& sensor)
{
    SliceCorrector corrector{recording.description, sensor};
    auto out = recording.slices.begin();  // never ahead of what is read
    for (ScanSlice& slice : recording.slices) {
        if (std::optional<ScanSlice> corrected = corrector.push(std::move(slice)))
            *out++ = std::move(*corrected);
    }
    if (std::optional<ScanSlice> last = corrector.finish())
        *out = std::move(*last);
    recording.description = corrector.description();
}

std::vector<double> noddingRates(const std::vector<ScanSlice>& slices)
{
    std::vector<double> rates(slices.size(), 0.0);
    const auto pitch = [&](std::size_t i) { return MeasuredPitch{slices[i].step, slices[i].tilt}; };
    for (std::size_t i = 0; i < slices.size(); ++i)
        rates[i] = noddingRate(pitch(i == 0 ? 0 : i - 1), pitch(std::min(i + 1, slices.size() - 1)));
    return rates;
}

}  // namespace planewright
