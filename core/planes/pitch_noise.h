// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include "core/params/parameters.h"
#include "core/planes/track_map.h"

namespace planewright {

/// Finds the noise of the pitch angle from how far whole slices are off the planes that grew over them.
class PitchNoise {
public:
    /// Looks at the slices before `end` that were not looked at yet, with a floor [m] of what segments may be off as a
    /// whole: what that may account for is not taken for noise of the pitch.
    void add(TrackMap& map, int end, const NoiseParameters& noise, double floor);

    /// Standard deviation of a slice's pitch [rad]. What was told counts like some slices, so that it holds until there
    /// are more, and the estimate stays between half of it and twice it: planes bend with the slices that they
    /// are made of.
    double estimate(double told) const;

private:
    /// Fills evidences_ with what the segments from one on tell, those of planes that tell something; nothing for the
    /// others.
    void collect(SegmentNumber first, SegmentNumber end, TrackMap& map, const NoiseParameters& noise, double floor);

    // Working storage, kept from call to call.
    std::vector<PitchEvidence> evidences_;
    std::vector<PitchEvidence> ofPlane_;

    int next_ = 0;
    int slices_ = 0;  // that told something
    bool lastTells_ = false;
    double lastError_ = 0.0;      // of the slice before [rad]
    double lastVariance_ = 0.0;   // [rad²]
    double squaredErrors_ = 0.0;  // sum over these [rad²]
};

}  // namespace planewright
