// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/geometry/slice_corrector.h"

#include <algorithm>
#include <utility>

namespace planewright {

double noddingRate(const MeasuredPitch& before, const MeasuredPitch& after)
{
    return after.step > before.step ? (after.tilt - before.tilt) / (after.step - before.step) : 0.0;
}

SliceCorrector::SliceCorrector(const ScanDescription& measured, const SensorParameters& sensor)
    : sensor_(sensor),
      measured_(sensorOf(measured)),
      description_(measured),
      needsNeighbours_(sensor.pitchDelay != 0.0 || sensor.sweepTurn != 0.0)
{
    description_.pitchAxisOffset += sensor.leverArmCorrection;
    if (sensor.rangeOffset != 0.0) {
        description_.rangeMin = std::max(0.0, description_.rangeMin + sensor.rangeOffset);
        description_.rangeMax = std::max(0.0, description_.rangeMax + sensor.rangeOffset);
    }
}

std::optional<ScanSlice> SliceCorrector::push(ScanSlice measured)
{
    if (!needsNeighbours_)
        return corrected(std::move(measured), 0.0);
    std::optional<ScanSlice> done;
    if (waiting_) {
        const MeasuredPitch here{waiting_->step, waiting_->tilt};
        const double rate = noddingRate(before_.value_or(here), {measured.step, measured.tilt});
        done = corrected(std::move(*waiting_), rate);
        before_ = here;
    }
    waiting_ = std::move(measured);
    return done;
}

std::optional<ScanSlice> SliceCorrector::finish()
{
    if (!waiting_)
        return std::nullopt;
    const MeasuredPitch here{waiting_->step, waiting_->tilt};
    const double rate = noddingRate(before_.value_or(here), here);
    ScanSlice last = corrected(std::move(*waiting_), rate);
    waiting_.reset();
    before_.reset();
    return last;
}

ScanSlice SliceCorrector::corrected(ScanSlice slice, double rate) const
{
    if (sensor_.rangeOffset != 0.0) {
        for (double& range : slice.ranges)
            range = measured_.hasEcho(range) ? std::max(0.0, range + sensor_.rangeOffset) : 0.0;
    }
    if (sensor_.pitchZero != 0.0 || needsNeighbours_) {
        const double end = slice.tiltEnd.value_or(slice.tilt);
        const double shift = sensor_.pitchZero + sensor_.pitchDelay * rate;
        slice.tilt += shift;
        if (slice.tiltEnd || sensor_.sweepTurn != 0.0)
            slice.tiltEnd = end + shift + sensor_.sweepTurn * rate;
    }
    return slice;
}

}  // namespace planewright
