// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>

#include "core/geometry/sensor_model.h"
#include "core/params/parameters.h"
#include "core/types/recording.h"

namespace planewright {

/// A slice's number and pitch as they were measured: what its neighbours need of it.
struct MeasuredPitch {
    int step = 0;
    double tilt = 0.0;  ///< [rad]
};

/// How far the head nods from one step to the next between two slices [rad]; missing steps count, a slice alone does
/// not nod.
double noddingRate(const MeasuredPitch& before, const MeasuredPitch& after);

/// Corrects slices by what a calibration has found (`sensor.*`), one after the other as they are measured: from then on
/// it is as if the scanner had been right. A correction that is zero leaves every number as it was.
///
/// A return becomes longer by the offset, and the limits of returns move with it, so that the same beams are returns;
/// one that would end at or behind the laser is none. The pitch of a beam grows by the zero, and where the head nods on
/// by the delay and by its share of the sweep's turn; the end pitch is set where there is such a turn.
///
/// How far the head nods at a slice is its noddingRate from the slice before to the slice after, one-sided at both
/// ends.
class SliceCorrector {
public:
    SliceCorrector(const ScanDescription& measured, const SensorParameters& sensor);

    /// What is said once about the corrected slices.
    const ScanDescription& description() const { return description_; }

    /// Takes the next slice as it was measured and gives the next corrected one: the same, or, where the way the head
    /// nods counts, the one before, which has waited for its neighbour.
    std::optional<ScanSlice> push(ScanSlice measured);

    /// The slice that still waits after the last one, if any.
    std::optional<ScanSlice> finish();

private:
    ScanSlice corrected(ScanSlice slice, double rate) const;

    SensorParameters sensor_;
    SensorModel measured_;
    ScanDescription description_;
    bool needsNeighbours_ = false;
    std::optional<MeasuredPitch> before_;  ///< of the slice before the one that waits
    std::optional<ScanSlice> waiting_;
};

}  // namespace planewright
